// SPDX-License-Identifier: MIT
// Objects of a PLC in XML as documents without markup: opened, saved, and spoken of with the language server,
// which knows the files only.

import * as fs from "node:fs";
import * as vscode from "vscode";
import type { Middleware } from "vscode-languageclient/node";
import { composed, HeadingError, Lines, parse, shown, SUFFIXES, taken, type Language, type Parts, type Place } from "./objects";

/** The scheme of the documents without markup; their paths are those of the files. */
export const SCHEME = "nctakt-plc";

/**
 * A document without markup: the file as it was read or saved last, and with the texts of the editor. While a
 * heading is missing, `isBroken`, these are the texts before.
 */
interface Open {
  base: Parts;
  now: Parts;
  lines: Lines;
  isBroken?: boolean;
}

const open = new Map<string, Open>();
/** Files that a person wants to see as they are. */
const raw = new Set<string>();

const encoder = new TextEncoder();
const headings = vscode.languages.createDiagnosticCollection("nctakt headings");

/** The language of findings and headings: that of the setting, else the one in which the editor is. */
export function language(): Language {
  const chosen = vscode.workspace.getConfiguration("nctakt").get<string>("language", "auto");
  return (chosen === "auto" ? vscode.env.language : chosen).startsWith("de") ? "de" : "en";
}

export const fileOf = (uri: vscode.Uri): vscode.Uri => uri.with({ scheme: "file" });
const shownOf = (uri: vscode.Uri): vscode.Uri => uri.with({ scheme: SCHEME });

function opened(base: Parts, now: Parts = base): Open {
  return { base, now, lines: new Lines(now) };
}

/** What is known of a document without markup; of one that comes back unsaved, the file as it is on disk. */
function stateOf(uri: vscode.Uri): Open | undefined {
  const known = open.get(uri.toString());
  if (known !== undefined) return known;
  try {
    const parts = parse(fs.readFileSync(fileOf(uri).fsPath, "utf8"));
    if (parts !== undefined) open.set(uri.toString(), opened(parts));
  } catch {
    return undefined; // the file is gone
  }
  return open.get(uri.toString());
}

/** Reads and writes the documents without markup. */
export class ObjectFiles implements vscode.FileSystemProvider {
  private readonly changed = new vscode.EventEmitter<vscode.FileChangeEvent[]>();
  readonly onDidChangeFile = this.changed.event;

  watch(uri: vscode.Uri): vscode.Disposable {
    const pattern = new vscode.RelativePattern(vscode.Uri.joinPath(fileOf(uri), ".."), uri.path.split("/").at(-1)!);
    const watcher = vscode.workspace.createFileSystemWatcher(pattern);
    watcher.onDidChange(() => this.changed.fire([{ type: vscode.FileChangeType.Changed, uri }]));
    watcher.onDidDelete(() => this.changed.fire([{ type: vscode.FileChangeType.Deleted, uri }]));
    return watcher;
  }

  async stat(uri: vscode.Uri): Promise<vscode.FileStat> {
    return vscode.workspace.fs.stat(fileOf(uri));
  }

  async readFile(uri: vscode.Uri): Promise<Uint8Array> {
    const parts = parse(await this.text(uri));
    if (parts === undefined) throw vscode.FileSystemError.Unavailable(vscode.l10n.t("{0}: no texts to show", uri.path));
    open.set(uri.toString(), opened(parts));
    return encoder.encode(shown(parts, language()));
  }

  /** Put the texts into the file as it is on disk now. */
  async writeFile(uri: vscode.Uri, content: Uint8Array): Promise<void> {
    const known = open.get(uri.toString());
    const disk = parse(await this.text(uri));
    if (known === undefined || disk === undefined || composed(disk) !== composed(known.base)) {
      throw vscode.FileSystemError.Unavailable(vscode.l10n.t("{0} has changed on disk meanwhile.", uri.path));
    }
    const now = withTexts(disk, new TextDecoder().decode(content));
    await vscode.workspace.fs.writeFile(fileOf(uri), encoder.encode(composed(now)));
    open.set(uri.toString(), opened(now));
  }

  private async text(uri: vscode.Uri): Promise<string> {
    const bytes = await vscode.workspace.fs.readFile(fileOf(uri));
    try {
      return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
    } catch {
      throw vscode.FileSystemError.Unavailable(vscode.l10n.t("{0}: not UTF-8", uri.path));
    }
  }

  private refuse(): never {
    throw vscode.FileSystemError.NoPermissions();
  }

  readDirectory = (): never => this.refuse();
  createDirectory = (): never => this.refuse();
  delete = (): never => this.refuse();
  rename = (): never => this.refuse();
}

/** The parts with the texts of an editor; the error that it throws is for a person. */
function withTexts(parts: Parts, text: string): Parts {
  try {
    return taken(parts, text, language());
  } catch (error) {
    if (!(error instanceof HeadingError)) throw error;
    throw vscode.FileSystemError.Unavailable(vscode.l10n.t("Not saved. {0}", wordsOf(error)));
  }
}

function wordsOf(error: HeadingError): string {
  return vscode.l10n.t("Each heading must stand once, in its order, as it was: {0}", error.heading);
}

/** Tell which heading is missing, at the beginning, or stands where it does not belong, there. */
function complain(uri: vscode.Uri, text: string, error: HeadingError): void {
  const line = Math.max(0, text.split(/\r?\n/).lastIndexOf(error.heading));
  const range = new vscode.Range(line, 0, line, error.heading.length);
  headings.set(uri, [new vscode.Diagnostic(range, wordsOf(error), vscode.DiagnosticSeverity.Error)]);
}

/** Show objects without markup when they are opened, unless a person wants the file. */
export function register(context: vscode.ExtensionContext): void {
  const files = new ObjectFiles();
  context.subscriptions.push(
    vscode.workspace.registerFileSystemProvider(SCHEME, files, { isCaseSensitive: true }),
    vscode.window.onDidChangeActiveTextEditor((editor) => void replace(editor)),
    headings,
    vscode.workspace.onDidCloseTextDocument(({ uri }) => {
      open.delete(uri.toString());
      headings.delete(uri);
    }),
    vscode.commands.registerCommand("nctakt.markup", async () => {
      const document = vscode.window.activeTextEditor?.document;
      if (document === undefined || !SUFFIXES.test(document.uri.path)) return;
      const isShown = document.uri.scheme === SCHEME;
      const file = fileOf(document.uri);
      if (isShown) raw.add(file.toString());
      else raw.delete(file.toString());
      await vscode.window.showTextDocument(isShown ? file : shownOf(file), { preview: false });
    }),
  );
  void replace(vscode.window.activeTextEditor);
}

async function replace(editor: vscode.TextEditor | undefined): Promise<void> {
  const uri = editor?.document.uri;
  if (editor === undefined || uri === undefined || uri.scheme !== "file" || !SUFFIXES.test(uri.path)) return;
  const isWanted = raw.has(uri.toString()) || editor.document.isDirty;
  const parts = isWanted ? undefined : parse(editor.document.getText());
  if (parts === undefined) return;
  const place = new Lines(parts).toShown(editor.selection.active);
  const isPreview = vscode.window.tabGroups.activeTabGroup.activeTab?.isPreview ?? true;
  const selection = place && new vscode.Range(place.line, place.character, place.line, place.character);
  await vscode.window.showTextDocument(shownOf(uri), { viewColumn: editor.viewColumn, preview: isPreview, selection });
  const left = vscode.window.tabGroups.all
    .flatMap((group) => group.tabs)
    .filter(({ input }) => input instanceof vscode.TabInputText && input.uri.toString() === uri.toString());
  await vscode.window.tabGroups.close(left);
}

// --- the language server, which knows the files -------------------------------------------------------------------

type Json = Record<string, unknown>;
type Map_ = (place: Place) => Place | undefined;

const isObject = (value: unknown): value is Json => typeof value === "object" && value !== null && !Array.isArray(value);
const isPlace = (value: unknown): value is Place & Json =>
  isObject(value) && typeof value["line"] === "number" && typeof value["character"] === "number";

class OutsideError extends Error {}

/** A value with all its places mapped; throws `OutsideError` for one that is not shown. */
function mapped(value: unknown, map: Map_): unknown {
  if (Array.isArray(value)) return value.map((one) => mapped(one, map));
  if (!isObject(value)) return value;
  if (isPlace(value)) {
    const found = map(value);
    if (found === undefined) throw new OutsideError();
    return found;
  }
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, mapped(one, map)]));
}

/** The document without markup of a file, with its lines: as it is open, else, or `isSaved`, as the file is. */
export function linesOf(file: string, isSaved = false): [vscode.Uri, Lines] | undefined {
  const uri = vscode.Uri.parse(file);
  if (uri.scheme !== "file" || !SUFFIXES.test(uri.path) || raw.has(uri.toString())) return undefined;
  const known = open.get(shownOf(uri).toString());
  if (known !== undefined && !isSaved) return [shownOf(uri), known.lines];
  try {
    const parts = parse(fs.readFileSync(uri.fsPath, "utf8"));
    return parts && [shownOf(uri), new Lines(parts)];
  } catch {
    return undefined;
  }
}

/** An answer of the server: places in files become places in documents without markup, where they are shown. */
function answered(value: unknown, own: Map_ | undefined): unknown {
  if (Array.isArray(value)) {
    return value.flatMap((one) => {
      try {
        return [answered(one, own)];
      } catch (error) {
        if (error instanceof OutsideError) return []; // a place in the markup is nobody's
        throw error;
      }
    });
  }
  if (!isObject(value)) return value;
  for (const key of ["uri", "targetUri"]) {
    const found = typeof value[key] === "string" ? linesOf(value[key]) : undefined;
    if (found === undefined) continue;
    try {
      const inside = mapped(value, (place) => found[1].toShown(place)) as Json;
      return { ...inside, [key]: found[0].toString() };
    } catch (error) {
      if (error instanceof OutsideError) return value;
      throw error;
    }
  }
  if (isObject(value["changes"])) {
    const changes = Object.entries(value["changes"]).map(([uri, edits]) => {
      const found = linesOf(uri);
      if (found === undefined) return [uri, edits];
      try {
        return [found[0].toString(), mapped(edits, (place) => found[1].toShown(place))];
      } catch (error) {
        if (error instanceof OutsideError) return [uri, edits]; // attributes change, too: in the file
        throw error;
      }
    });
    return { ...value, changes: Object.fromEntries(changes) };
  }
  if (typeof value["startLine"] === "number" && typeof value["endLine"] === "number" && own !== undefined) {
    const [first, last] = [value["startLine"], value["endLine"]].map((line) => own({ line, character: 0 })?.line);
    if (first === undefined || last === undefined) throw new OutsideError();
    return { ...value, startLine: first, endLine: last };
  }
  if (isPlace(value)) return own === undefined ? value : mapped(value, own);
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, answered(one, own)]));
}

/** The semantic tokens of a file as those of what is shown: both are distances from the token before. */
function tokens(data: number[], map: Map_): number[] {
  const found: number[] = [];
  let [line, character, lineBefore, characterBefore] = [0, 0, 0, 0];
  for (let index = 0; index + 4 < data.length; index += 5) {
    const [lines, characters] = [data[index]!, data[index + 1]!];
    line += lines;
    character = lines ? characters : character + characters;
    const place = map({ line, character });
    if (place === undefined) continue;
    const down = place.line - lineBefore;
    found.push(down, down ? place.character : place.character - characterBefore, ...data.slice(index + 2, index + 5));
    [lineBefore, characterBefore] = [place.line, place.character];
  }
  return found;
}

function diagnosticsOf(lines: Lines, diagnostics: readonly vscode.Diagnostic[]): vscode.Diagnostic[] {
  return diagnostics.map((one) => {
    const [start, end] = [one.range.start, one.range.end].map((place) => lines.toShown(place));
    const copy = Object.assign(Object.create(Object.getPrototypeOf(one)), one) as vscode.Diagnostic;
    copy.range = new vscode.Range(
      start?.line ?? 0,
      start?.character ?? 0,
      end?.line ?? start?.line ?? 0,
      end?.character ?? start?.character ?? 1,
    );
    return copy;
  });
}

/** What stands between the client and the server. */
export const middleware: Middleware = {
  handleDiagnostics(uri, diagnostics, next) {
    const own = open.get(shownOf(uri).toString());
    if (own === undefined) {
      if (SUFFIXES.test(uri.path)) next(shownOf(uri), []);
      return next(uri, diagnostics);
    }
    next(uri, []);
    next(shownOf(uri), diagnosticsOf(own.lines, diagnostics));
  },
  async sendNotification(type, next, params) {
    const method = typeof type === "string" ? type : type.method;
    const item = isObject(params) && isObject(params["textDocument"]) ? params["textDocument"] : undefined;
    if (item === undefined || typeof item["uri"] !== "string") return next(type, params);
    const uri = vscode.Uri.parse(item["uri"]);
    if (uri.scheme !== SCHEME) {
      return open.has(shownOf(uri).toString()) ? undefined : next(type, params); // one text of a file at a time
    }
    const textDocument: Json = { ...item, uri: fileOf(uri).toString() };
    const changed: Json = { ...(params as Json), textDocument };
    if (["textDocument/didOpen", "textDocument/didChange"].includes(method)) {
      const known = stateOf(uri);
      if (known === undefined) return;
      const document = vscode.workspace.textDocuments.find((one) => one.uri.toString() === uri.toString());
      const shownText = document?.getText() ?? "";
      try {
        open.set(uri.toString(), opened(known.base, taken(known.base, shownText, language())));
        headings.delete(uri);
      } catch (error) {
        if (!(error instanceof HeadingError)) throw error;
        open.set(uri.toString(), { ...known, isBroken: true });
        complain(uri, shownText, error);
        if (method === "textDocument/didChange") return; // the texts cannot be told apart
      }
      const text = composed(open.get(uri.toString())!.now).replace(/^\uFEFF/, "");
      if (method === "textDocument/didOpen") textDocument["text"] = text;
      else changed["contentChanges"] = [{ text }];
    }
    return next(type, changed as typeof params);
  },
  async sendRequest(type, param, token, next) {
    const item = isObject(param) && isObject(param["textDocument"]) ? param["textDocument"] : undefined;
    const uri = typeof item?.["uri"] === "string" ? vscode.Uri.parse(item["uri"]) : undefined;
    const own = uri?.scheme === SCHEME ? open.get(uri.toString()) : undefined;
    if (own === undefined) return answered(await next(type, param, token), undefined) as never;
    if (own.isBroken) return null as never;
    const toFile = mapped(param, (place) => own.lines.toFile(place)) as Json;
    const asked = { ...toFile, textDocument: { ...item, uri: fileOf(uri!).toString() } };
    const answer: unknown = await next(type, asked as typeof param, token);
    const lines = (open.get(uri!.toString()) ?? own).lines;
    const map: Map_ = (place) => lines.toShown(place);
    if (isObject(answer) && Array.isArray(answer["data"]) && Object.keys(answer).every((key) => /^data|resultId$/.test(key))) {
      return { ...answer, data: tokens(answer["data"] as number[], map) } as never;
    }
    try {
      return answered(answer, map) as never;
    } catch (error) {
      if (error instanceof OutsideError) return null as never;
      throw error;
    }
  },
};
