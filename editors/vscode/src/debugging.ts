// SPDX-License-Identifier: MIT
// The debugger in documents without markup: its lines are those of the files.

import * as vscode from "vscode";
import type { Lines, Place } from "./objects";
import { fileOf, linesOf, SCHEME } from "./shown";

type Json = Record<string, unknown>;

const isObject = (value: unknown): value is Json => typeof value === "object" && value !== null && !Array.isArray(value);

/** Change line and column of a place, both from 1; nothing changes where it is not shown. */
function move(place: Json, line: string, column: string, map: (place: Place) => Place | undefined): boolean {
  if (typeof place[line] !== "number") return false;
  const character = typeof place[column] === "number" ? Math.max(0, place[column] - 1) : 0;
  const found = map({ line: place[line] - 1, character });
  if (found === undefined) return false;
  place[line] = found.line + 1;
  if (typeof place[column] === "number") place[column] = found.character + 1;
  return true;
}

/** A request about a document without markup becomes one about its file. */
function toFile(words: unknown): void {
  if (!isObject(words) || !isObject(words["source"]) || typeof words["source"]["path"] !== "string") return;
  const path = words["source"]["path"];
  if (!path.startsWith(`${SCHEME}:`)) return;
  const file = fileOf(vscode.Uri.parse(path));
  const found = linesOf(file.toString(), true);
  if (found === undefined) return;
  const map = (place: Place): Place => found[1].toFile(place);
  words["source"] = { ...words["source"], path: file.fsPath };
  move(words, "line", "column", map);
  move(words, "endLine", "endColumn", map);
  const { breakpoints, lines } = words;
  if (Array.isArray(breakpoints)) words["breakpoints"] = breakpoints.map((one: Json) => ({ ...one }));
  for (const one of Array.isArray(breakpoints) ? (words["breakpoints"] as Json[]) : []) move(one, "line", "column", map);
  if (Array.isArray(lines)) words["lines"] = lines.map((line: number) => map({ line: line - 1, character: 0 }).line + 1);
}

/** Places in files become places in documents without markup, where they are shown. */
function toShown(value: unknown): void {
  if (Array.isArray(value)) value.forEach(toShown);
  if (!isObject(value)) return;
  const source = value["source"];
  if (isObject(source) && typeof source["path"] === "string" && typeof value["line"] === "number") {
    const found = linesOf(vscode.Uri.file(source["path"]).toString(), true);
    if (found !== undefined) show(value, source, ...found);
    return;
  }
  Object.values(value).forEach(toShown);
}

function show(place: Json, source: Json, uri: vscode.Uri, lines: Lines): void {
  const map = (asked: Place): Place | undefined =>
    (asked.character ? lines.toShown(asked) : undefined) ?? lines.lastIn(asked.line);
  if (!move(place, "line", "column", map)) return;
  if (!move(place, "endLine", "endColumn", map)) delete place["endLine"];
  place["source"] = { ...source, path: uri.toString() };
}

/** Stands between the editor and the debug adapter. */
export const tracker: vscode.DebugAdapterTrackerFactory = {
  createDebugAdapterTracker: () => ({
    onWillReceiveMessage: (message: unknown) => void (isObject(message) && toFile(message["arguments"])),
    onDidSendMessage: (message: unknown) => void (isObject(message) && toShown(message["body"])),
  }),
};
