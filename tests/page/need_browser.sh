# SPDX-License-Identifier: MIT
# Sets $python to a Python with selenium. Ends the test with exit code 77, skipped, where there is none, or no Chromium with its
# driver. Source it.
python=
for candidate in python3 /usr/bin/python3; do
  [ -z "$python" ] && "$candidate" -c 'import selenium' 2>/dev/null && python=$candidate
done
if [ -z "$python" ] || ! command -v chromium >/dev/null || ! command -v chromedriver >/dev/null; then
  echo "no chromium, chromium-driver and python3-selenium: skipped"
  exit 77
fi
