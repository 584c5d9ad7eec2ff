# SPDX-License-Identifier: MIT
# A filter for Doxygen: in comments, what follows a numbered list without being indented is no part of its last item.
/^ *\/\/\/ [^ 0-9]/ && in_list { print "///" }
{
  in_list = /^ *\/\/\/ [0-9]+\. / || (in_list && /^ *\/\/\/  /)
  print
}
