# SPDX-License-Identifier: MIT
# Sets $page to the page for dropped models. Ends the test with exit code 77, skipped, where it was not built. Source it.
page=$(realpath "$(dirname "${BASH_SOURCE[0]}")")/../../culler/js/page/site/index.html
if [ ! -e "$page" ]; then
  echo "no page (culler/js/page/build.sh): skipped"
  exit 77
fi
