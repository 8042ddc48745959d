#!/usr/bin/env bash
# pack.sh MODULES NOTICES OUT: the npm package, OUT/flowcert-VERSION.tgz. Needs npm, and no network.
#
# MODULES has the files that the build makes, and NOTICES is /usr/share/doc of the system that they were made on,
# beside its common-licenses. Prints the sizes of the modules as they are and compressed.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
modules=$1 notices=$2 out=$(realpath -m "$3")
packages=(emscripten libcgal-dev libeigen3-dev libexpat1-dev libfast-float-dev libfmt-dev libgmp-dev libmpfr-dev
          nlohmann-json3-dev zlib1g-dev)

rm -rf "$out/package"
mkdir -p "$out/package/notices"
cp "$here"/{NOTICES.md,README.md,disposable.d.ts,index.d.ts,index.js,package.json} "$here/../../../LICENSE" "$out/package"
cp "$modules"/{flowcert,radii,check}_module.{js,wasm} "$out/package"
# The page as it is before and behind its data. Nothing of it is under the GPL.
node -e '
  const [page, out] = process.argv.slice(1), place = `<script type="application/json" id="flowcert-data">null</script>`;
  const parts = fs.readFileSync(page, "utf8").split(place);
  if (parts.length !== 2) throw new Error("the page has its place for data once");
  const names = ["before", "behind"].map((name, k) => `export const ${name} = ${JSON.stringify(parts[k])};\n`);
  fs.writeFileSync(out, names.join(""));
' "$here/../../viewer/page.html" "$out/package/viewer_page.js"
for package in "${packages[@]}"; do cp -L "$notices/$package/copyright" "$out/package/notices/$package.txt"; done
# The two megabytes of Boost's file are of parts that are not used.
boost=$(ls -d "$notices"/libboost1.*-dev | head -n 1)
sed -n '/^ Boost Software License - /,/^$/p' "$boost/copyright" >"$out/package/notices/boost.txt"
for licence in Apache-2.0 LGPL-3 MPL-2.0; do cp "$notices/../common-licenses/$licence" "$out/package/notices"; done
for module in flowcert_module radii_module check_module; do
  file=$out/package/$module.wasm
  echo "$module.wasm: $(stat -c %s "$file") bytes, $(gzip -9c "$file" | wc -c) with gzip"
done
cd "$out"
npm pack --offline --silent ./package
git -C "$here" rev-parse HEAD >commit
