# Compares what each target has drawn with hashes.txt, and prints it.
#   awk -v hashes=FILE -v form=text|markdown|json [-v head=TEXT] -f report.awk ROWS
# ROWS has a line "number|name|compiler and options|folder" for each target; run.sh says what is in
# the folders. A case is `=` if all of its buffers are equal, X if one is not, and . if not drawn.
# Ends with 1 if a target differs or fails.
function slurp(file,   line) {
  line = ""
  if ((getline line < file) <= 0) line = ""
  close(file)
  return line
}
function millions(n) { return sprintf("%.2f", n / 1000000) }

BEGIN {
  FS = "|"
  while ((getline line < hashes) > 0) {
    split(line, word, " ")
    if (!(word[1] in buffers)) listed[++cases] = word[1]
    buffers[word[1]]++
    expected[word[1] " " word[2]] = word[3]
  }
  at = 0
  for (k = 1; k <= cases; ++k) if (listed[k] ~ /^fig[1-8]$/) order[++at] = listed[k]
  for (k = 1; k <= cases; ++k) if (listed[k] !~ /^fig[1-8]$/) order[++at] = listed[k]
  expected["canvas picture6"] = expected["fig6 picture6"]
  bad = 0
}

# What a target has printed: into equal[case], different[case], stage[name], most, stack.
function read_lines(file,   line, word, key) {
  split("", equal); split("", different); split("", stage); split("", differing)
  most = stack = instructions = 0
  canvas = ""
  while ((getline line < file) > 0) {
    split(line, word, " ")
    key = word[2] " " word[3]
    if (word[1] == "buffer") {
      if (expected[key] == word[4]) equal[word[2]]++
      else { different[word[2]]++; differing[key] = word[4] }
      if (word[2] == "canvas") canvas = expected[key] == word[4] ? "=" : "X"
    }
    if (word[1] == "stage") { stage[key] = word[4]; instructions += word[4] }
    if (word[1] == "memory" && word[3] > most) most = word[3]
    if (word[1] == "stack") stack = word[2]
  }
  close(file)
}
function mark(c) {
  if (different[c] > 0) return "X"
  if (equal[c] == 0) return "."
  return equal[c] == buffers[c] ? "=" : "X"
}
function marks(from, to,   k, made) {
  made = ""
  for (k = from; k <= to; ++k) made = made mark(order[k])
  return made
}

{
  n = NR
  name[n] = $2
  options[n] = $3
  status[n] = slurp($4 "/status")
  if (status[n] == "") status[n] = "failed: it was not run"
  read_lines($4 "/lines")
  all = marks(1, cases)
  figures[n] = substr(all, 1, 8)
  others[n] = substr(all, 9)
  shown[n] = canvas
  built[n] = slurp($4 "/built")
  ran[n] = slurp($4 "/ran")
  split(slurp($4 "/bytes"), of, " ")
  text[n] = of[1]
  zeros[n] = of[2] + of[3]
  largest[n] = most
  stacks[n] = stack
  instructed[n] = instructions
  for (key in stage) stages[n, key] = stage[key]
  list[n] = ""
  for (key in equal) equals[n] += equal[key]
  for (key in differing)
    list[n] = list[n] sprintf("%s{\"buffer\": \"%s\", \"is\": \"%s\", \"should_be\": \"%s\"}",
                              list[n] == "" ? "" : ", ", key, differing[key], expected[key])
  if (status[n] ~ /^failed/ || all ~ /X/ || canvas == "X") bad = 1
  if (status[n] == "drawn" && all !~ /=/) { status[n] = "failed: it drew nothing"; bad = 1 }
  if (status[n] == "drawn" && all !~ /X/) drawn++
}

function legend(   k, made) {
  made = ""
  for (k = 9; k <= cases; ++k) made = made (k > 9 ? ", " : "") order[k]
  return made
}
function note(k) {
  if (status[k] != "drawn") return status[k]
  return shown[k] == "" ? "" : "canvas read back: " shown[k]
}

function print_text(   k) {
  for (k = 1; k <= n; ++k)
    printf "%-28s %-8s %-24s %8s s %8s s  %s\n", name[k], figures[k], others[k], built[k], ran[k],
           note(k)
  print "figures 1 to 8; then " legend()
  print "=: equal, X: different, .: not drawn; seconds of processor time to build and to run"
  for (k = 1; k <= n; ++k)
    if (status[k] ~ /^skipped/) {
      why = status[k]
      sub(/^skipped: /, "", why)
      print "skipped: " name[k] ": " why
    }
  printf "%d of %d targets equal in all that they draw\n", drawn, n
}
function print_markdown(   k, sum, part, s) {
  print head
  print "| target | compiler and options | figures 1 to 8 | methods and lights | builds, s | " \
        "runs, s | |"
  print "|---|---|---|---|---|---|---|"
  for (k = 1; k <= n; ++k)
    printf "| %s | `%s` | `%s` | `%s` | %s | %s | %s |\n", name[k], options[k], figures[k],
           others[k], built[k], ran[k], note(k)
  print "\nMethods and lights, in their order: " legend() "."
  print "\n| target | program, bytes | data | largest frame | stack | RAM, all" \
        " | figure 6, million " \
        "instructions: matrices | light | observer | shadow | filters | sum | all cases |"
  print "|---|---|---|---|---|---|---|---|---|---|---|---|---|"
  split("matrices light observer shadow filters", part, " ")
  for (k = 1; k <= n; ++k) {
    if (stacks[k] == 0) continue
    data = zeros[k] - 1048576 - 3670016
    printf "| %s | %d | %d | %d | %d | %d |", name[k], text[k], data, largest[k], stacks[k],
           data + largest[k] + stacks[k]
    sum = 0
    for (s = 1; s <= 5; ++s) {
      printf " %s |", millions(stages[k, "fig6 " part[s]])
      sum += stages[k, "fig6 " part[s]]
    }
    printf " %s | %s |\n", millions(sum), millions(instructed[k])
  }
}
function print_json(   k) {
  print "{\"cases\": ["
  for (k = 1; k <= cases; ++k) printf "  \"%s\"%s\n", order[k], k < cases ? "," : ""
  print "],\n\"targets\": ["
  for (k = 1; k <= n; ++k)
    printf "  {\"name\": \"%s\", \"compiler\": \"%s\", \"status\": \"%s\", \"marks\": \"%s\", " \
           "\"equal\": %d, \"different\": [%s], \"build_s\": %.2f, \"run_s\": %.2f, " \
           "\"instructions\": %.0f, \"stack_bytes\": %d, \"frame_bytes\": %d}%s\n",
           name[k], options[k], status[k], figures[k] others[k], equals[k], list[k], built[k],
           ran[k], instructed[k], stacks[k], largest[k], k < n ? "," : ""
  print "]}"
}

END {
  if (form == "markdown") print_markdown()
  else if (form == "json") print_json()
  else print_text()
  exit bad
}
