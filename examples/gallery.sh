#!/usr/bin/env bash
# A page with a card for each example, each leading to its replay: bash examples/gallery.sh
#
# Writes out/gallery/index.html, and beside it one page and one picture an example. Needs build/release/carom; where that is not
# there, examples/quickstart.sh builds it first. Pages hold the first 20000 collisions of a run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
carom=build/release/carom
gallery=out/gallery

[[ -x $carom ]] || bash examples/quickstart.sh
mkdir -p "$gallery"

escaped() { sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g'; }
# Its title, and the first line of its comment without the "# ".
title_of() { sed -n 's/^title = "\(.*\)"/\1/p' "$1" | head -n 1 | escaped; }
subject_of() { head -n 1 "$1" | sed 's/^# *//' | escaped; }

card() {
  local name=$1 scene=examples/$1/scene.toml status=0
  "$carom" view "examples/$name" --most 20000 --out "$gallery/$name.html" --picture "$gallery/$name.svg" > /dev/null 2> "$gallery/log" || status=$?
  if ((status != 0 && status != 3)); then  # 3: the run stopped before its end, and the page shows it up to there
    cat "$gallery/log" >&2
    return 1
  fi
  cat << EOF
<a class="card" href="$name.html"><img src="$name.svg" alt=""><h2>$(title_of "$scene")</h2><p>$(subject_of "$scene")</p><code>carom view examples/$name</code></a>
EOF
}

{
  cat << 'EOF'
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>carom: gallery</title>
<style>
:root { --ground: #f3f2ee; --paper: #fff; --ink: #1d2329; --muted: #6a727b; --line: #dcdad2; }
@media (prefers-color-scheme: dark) { :root { --ground: #101418; --paper: #181d23; --ink: #e9ebee; --muted: #8f99a4; --line: #2a313a; } }
body { margin: 0 auto; max-width: 1320px; padding: 28px 20px 48px; background: var(--ground); color: var(--ink); font: 14px/1.45 system-ui, sans-serif; }
h1 { font-size: 26px; margin: 0 0 4px; letter-spacing: -.01em; }
header p { color: var(--muted); margin: 0 0 22px; }
main { display: grid; gap: 16px; grid-template-columns: repeat(auto-fill, minmax(270px, 1fr)); }
.card { display: flex; flex-direction: column; background: var(--paper); border-radius: 12px; overflow: hidden; color: inherit; text-decoration: none; box-shadow: 0 1px 2px rgba(30, 30, 20, .08); transition: transform .12s; }
.card:hover, .card:focus-visible { transform: translateY(-2px); box-shadow: 0 4px 18px rgba(30, 30, 20, .16); }
.card img { width: 100%; aspect-ratio: 8 / 5; display: block; border-bottom: 1px solid var(--line); }
.card h2 { font-size: 15px; margin: 12px 14px 2px; }
.card p { margin: 0 14px 10px; color: var(--muted); flex: 1; }
.card code { margin: 0 14px 14px; font: 11.5px ui-monospace, 'DejaVu Sans Mono', monospace; color: var(--muted); overflow-wrap: anywhere; }
</style>
</head>
<body>
<header><h1>carom</h1><p>Hard balls, moved exactly. Each card leads to a replay of the run: every collision at its own moment, at any speed.</p></header>
<main>
EOF
  for scene in examples/*/scene.toml; do
    name=${scene#examples/}
    name=${name%/scene.toml}
    echo "  $name" >&2
    card "$name"
  done
  echo '</main></body></html>'
} > "$gallery/index.html"
rm -f "$gallery/log"
echo "Wrote $gallery/index.html. Open it in a browser."
