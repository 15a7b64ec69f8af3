// SPDX-License-Identifier: MIT
// The grammar over all programs below some folders: each line has colours, none is marked as invalid.

import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

const require = createRequire(import.meta.url);
const textmate = require("vscode-textmate");
const oniguruma = require("vscode-oniguruma");

const here = path.dirname(new URL(import.meta.url).pathname);
const wasm = readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm"));
await oniguruma.loadWASM(wasm.buffer);
const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async (scope) => {
    const name = `${scope.replace("source.", "")}.tmLanguage.json`;
    const file = path.join(here, "..", "syntaxes", name);
    return textmate.parseRawGrammar(readFileSync(file, "utf8"), file);
  },
});
const grammars = {
  program: await registry.loadGrammar("source.nctakt"),
  structured: await registry.loadGrammar("source.nctakt-st"),
};
const files = process.argv
  .slice(2)
  .flatMap((folder) => readdirSync(folder, { recursive: true }).map((name) => path.join(folder, name)))
  .filter((name) => /\.(nc|sub|cyc|st)$/i.test(name));
let wrong = 0;
for (const name of files) {
  const grammar = /\.st$/i.test(name) ? grammars.structured : grammars.program;
  const own = grammar === grammars.structured ? "source.nctakt-st" : "source.nctakt";
  let state = textmate.INITIAL;
  const lines = readFileSync(name, "utf8").split(/\r?\n/);
  lines.forEach((line, index) => {
    const result = grammar.tokenizeLine(line, state);
    state = result.ruleStack;
    const scopes = result.tokens.flatMap((token) => token.scopes);
    const isSigns = grammar === grammars.structured && !/\w/.test(line);
    const isPlain = !isSigns && line.trim() !== "" && scopes.every((scope) => scope === own);
    if (isPlain || scopes.some((scope) => scope.startsWith("invalid"))) {
      console.error(`${name}:${index + 1}: ${line}`);
      wrong += 1;
    }
  });
}
console.log(`${files.length} programs, ${wrong} lines without the right colour`);
process.exit(files.length > 0 && wrong === 0 ? 0 : 1);
