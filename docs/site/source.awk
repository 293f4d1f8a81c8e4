# A header for Doxygen: the comment that opens it describes the file, and mathematics in comments is text, not markup; code between
# backticks stays code.
function plain(text,   parts, n, i, result) {
  n = split(text, parts, "`")
  for (i = 1; i <= n; ++i) {
    if (i % 2) {
      gsub(/&/, "\\&amp;", parts[i])
      gsub(/</, "\\&lt;", parts[i])
      gsub(/>/, "\\&gt;", parts[i])
      gsub(/[\\@#*|]|::/, "\\\\&", parts[i])
    }
    result = result (i > 1 ? "`" : "") parts[i]
  }
  return result
}
NR == 1 && /^\/\// { print "/** @file"; print "@brief " plain(substr($0, 4)); print "@verbatim"; opening = 1; next }
opening && /^\/\// { print substr($0, 4); next }
opening { print "@endverbatim */"; opening = 0 }
match($0, /\/\/\/<?/) { print substr($0, 1, RSTART + RLENGTH - 1) plain(substr($0, RSTART + RLENGTH)); next }
{ print }
