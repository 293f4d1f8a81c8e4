# A guide for Doxygen, which names headings in its own way: links to a heading of another page become links to the page,
# those to a heading of the same page become text. LaTeX between dollars becomes code: a page needs no network to show it.
{
  while (match($0, /\]\([a-z0-9\/._-]+\.md#[^)]*\)/)) {
    link = substr($0, RSTART, RLENGTH)
    sub(/#[^)]*/, "", link)
    $0 = substr($0, 1, RSTART - 1) link substr($0, RSTART + RLENGTH)
  }
  while (match($0, /\[[^][]*\]\(#[^)]*\)/)) {
    link = substr($0, RSTART + 1, RLENGTH - 1)
    sub(/\]\(#.*/, "", link)
    $0 = substr($0, 1, RSTART - 1) link substr($0, RSTART + RLENGTH)
  }
  count = split($0, spans, "`")
  if (count % 2) {
    $0 = ""
    for (i = 1; i <= count; ++i) {
      if (i % 2 && split(spans[i], parts, "$") % 2) gsub(/\$/, "``", spans[i])
      $0 = $0 (i > 1 ? "`" : "") spans[i]
    }
  }
  print
}
