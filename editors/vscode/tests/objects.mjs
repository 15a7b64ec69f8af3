// SPDX-License-Identifier: MIT
// Objects in XML as they are shown, and back: only the text that was edited changes in the file.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(import.meta.url);
const here = path.dirname(new URL(import.meta.url).pathname);
const folder = mkdtempSync(path.join(tmpdir(), "objects-"));
const outfile = path.join(folder, "objects.mjs");
require("esbuild").buildSync({
  entryPoints: [path.join(here, "..", "src", "objects.ts")], bundle: true, format: "esm", outfile, logLevel: "error",
});
const { parse, shown, taken, composed, Lines, HeadingError } = await import(pathToFileURL(outfile).href);
rmSync(folder, { recursive: true });

const FILE = `\uFEFF<?xml version="1.0" encoding="utf-8"?>
<!-- <ST>no text</ST> -->
<TcPlcObject Version="1.1.0.1" ProductVersion="3.1.4024.0">
  <POU Name="FB_Gate" Id="{a-b}" SpecialFunc="None">
    <Declaration><![CDATA[FUNCTION_BLOCK FB_Gate
VAR
    n : INT;
END_VAR
]]></Declaration>
    <Implementation>
      <ST><![CDATA[n := n + 1; // </ST> > & ]]]]><![CDATA[>
]]></ST>
    </Implementation>
    <Folder Name="Parts" Id="{c}" />
    <Method Name="Run" Id="{d}">
      <Declaration><![CDATA[METHOD Run]]></Declaration><Implementation><ST>n := n &lt;&gt; 2;
b := TRUE;</ST></Implementation>
    </Method>
    <Property Name="Open" Id="{e}"><Declaration><![CDATA[PROPERTY Open : BOOL]]></Declaration>
      <Get Name="Get" Id="{f}"><Declaration><![CDATA[]]></Declaration><Implementation><ST><![CDATA[Open := n > 1;]]></ST>
      </Implementation></Get></Property>
    <LineIds Name="FB_Gate"><LineId Id="3" Count="0" /></LineIds>
  </POU>
</TcPlcObject>`;
const TEXT = `// ════ FB_Gate · declaration ════
FUNCTION_BLOCK FB_Gate
VAR
    n : INT;
END_VAR

// ════ FB_Gate · implementation ════
n := n + 1; // </ST> > & ]]>

// ════ FB_Gate.Run · declaration ════
METHOD Run
// ════ FB_Gate.Run · implementation ════
n := n <> 2;
b := TRUE;
// ════ FB_Gate.Open · declaration ════
PROPERTY Open : BOOL
// ════ FB_Gate.Open.Get · declaration ════

// ════ FB_Gate.Open.Get · implementation ════
Open := n > 1;`;

for (const end of ["\n", "\r\n"]) {
  const file = FILE.replaceAll("\n", end);
  const parts = parse(file);
  assert.equal(shown(parts, "en"), TEXT);
  assert.equal(composed(parts), file);
  assert.equal(composed(taken(parts, TEXT, "en")), file);
  assert.equal(composed(taken(parts, TEXT.replaceAll("\n", "\r\n"), "en")), file);
  // an edit of one text changes nothing but that
  const edited = taken(parts, TEXT.replace("n + 1;", "n + 2;\nm := 1;"), "en");
  assert.equal(composed(edited), file.replace("n + 1;", `n + 2;${end}m := 1;`));
  const escaped = taken(parts, TEXT.replace("n <> 2", "n < 3 & ]]>"), "en");
  assert.equal(composed(escaped), file.replace("n &lt;&gt; 2", "n &lt; 3 &amp; ]]&gt;"));
  assert.equal(composed(taken(parts, TEXT.replace("METHOD Run", "METHOD Run // ]]>"), "en")),
    file.replace("METHOD Run]", "METHOD Run // ]]]]><![CDATA[>]"));
  assert.equal(shown(parse(composed(edited)), "en"), TEXT.replace("n + 1;", "n + 2;\nm := 1;"));
  // places, both ways
  const lines = new Lines(parts);
  const [textLines, fileLines] = [TEXT.split("\n"), file.split(end)];
  for (const [line, character] of [[1, 9], [3, 4], [4, 7], [7, 2], [10, 0], [13, 1], [15, 3], [19, 8]]) {
    const place = lines.toFile({ line, character });
    assert.ok(fileLines[place.line].slice(place.character).startsWith(textLines[line].slice(character, character + 3)));
    assert.deepEqual(lines.toShown(place), { line, character });
  }
  const shared = fileLines.findIndex((line) => line.includes("METHOD Run"));
  assert.deepEqual(lines.lastIn(shared), { line: 12, character: 0 });
  assert.equal(lines.lastIn(0), undefined);
  assert.deepEqual(lines.toFile({ line: 0, character: 5 }), lines.toFile({ line: 1, character: 0 }));
  assert.equal(lines.toShown({ line: 0, character: 3 }), undefined);
  assert.equal(lines.toShown({ line: 9, character: 8 }), undefined);
}
// headings that are gone, doubled, changed, in another order, or after a text
const parts = parse(FILE);
const heading = "// ════ FB_Gate · implementation ════";
for (const wrong of [
  TEXT.replace(`${heading}\n`, ""), TEXT.replace(heading, `${heading}\n${heading}`), TEXT.replace("Run · declaration", "Runs · declaration"),
  `x := 1;\n${TEXT}`, TEXT.replace("FB_Gate · declaration", "?").replace("FB_Gate · implementation", "FB_Gate · declaration").replace("?", "FB_Gate · implementation"),
]) assert.throws(() => taken(parts, wrong, "en"), HeadingError);
// what holds no texts, or holds them in another way, is shown as it is
for (const other of ["", "<TcPlcObject/>", "<POU><Implementation><NWL><XmlArchive/></NWL></Implementation></POU>",
  "<POU><Declaration>PROGRAM <b>A</b></Declaration></POU>", "<POU><Declaration><![CDATA[A]]> B</Declaration></POU>", "<POU><Declaration>A"]) {
  assert.equal(parse(other), undefined, other);
}
assert.equal(shown(parse('<DUT Name="E"><Declaration>TYPE E : (A); END_TYPE</Declaration></DUT>'), "de"),
  "// ════ E · Deklaration ════\nTYPE E : (A); END_TYPE");
console.log("objects: as shown, and back");
