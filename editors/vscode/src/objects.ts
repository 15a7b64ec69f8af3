// SPDX-License-Identifier: MIT
// An object of a PLC in XML <-> its texts as the programmer knows them, each below a heading.
// Nothing but the texts changes in the file, byte by byte.

export interface Place {
  line: number;
  character: number;
}

export interface Range {
  start: Place;
  end: Place;
}

/** The object that a text belongs to, and whether it is the declaration. */
export interface Title {
  name: string;
  isDeclaration: boolean;
}

/** A file: its texts as they are written there, and what lies before, between and after them. */
export interface Parts {
  between: string[];
  texts: string[];
  isCdata: boolean[];
  titles: Title[];
}

export type Language = "en" | "de";

const TAGS = /<!\[CDATA\[[\s\S]*?\]\]>|<!--[\s\S]*?-->|<\?[\s\S]*?\?>|<\/?([\w:.-]+)((?:"[^"]*"|'[^']*'|[^>"'])*?)(\/?)>/g;
const OWNERS = new Set(["POU", "DUT", "GVL", "Itf", "Method", "Property", "Action", "Get", "Set"]);
const ENTITIES: Record<string, string> = { lt: "<", gt: ">", amp: "&", quot: '"', apos: "'" };
const SPLIT = "]]]]><![CDATA[>";

/** The suffixes of files that hold objects in XML. */
export const SUFFIXES = /\.(TcPOU|TcDUT|TcGVL|TcIO)$/i;

/** A text cannot be assigned to the file: a heading is missing, or is there twice. */
export class HeadingError extends Error {
  constructor(readonly heading: string) {
    super(heading);
  }
}

/** The parts of a file; nothing where it holds none, or its texts are written in another way. */
export function parse(xml: string): Parts | undefined {
  const parts: Parts = { between: [], texts: [], isCdata: [], titles: [] };
  const owners: { tag: string; name: string }[] = [];
  let end = 0;
  let begin = -1;
  let opened = "";
  for (const match of xml.matchAll(TAGS)) {
    const [whole, tag, attributes, closed] = match;
    const at = match.index ?? 0;
    if (tag === undefined) continue;
    const isEnd = whole.startsWith("</");
    if (begin >= 0) {
      if (!isEnd || tag !== opened) return undefined; // elements in a text
      const found = content(xml, begin, at);
      if (found === undefined) return undefined;
      const [first, last, isCdata] = found;
      const name = owners.map((one) => one.name).join(".");
      parts.between.push(xml.slice(end, first));
      parts.texts.push(xml.slice(first, last));
      parts.isCdata.push(isCdata);
      parts.titles.push({ name, isDeclaration: tag === "Declaration" });
      end = last;
      begin = -1;
    } else if (isEnd) {
      if (owners.at(-1)?.tag === tag) owners.pop();
    } else if (closed === "" && (tag === "Declaration" || tag === "ST")) {
      [begin, opened] = [at + whole.length, tag];
    } else if (closed === "" && OWNERS.has(tag)) {
      owners.push({ tag, name: /\bName="([^"]*)"/.exec(attributes ?? "")?.[1] ?? tag });
    }
  }
  parts.between.push(xml.slice(end));
  return parts.texts.length > 0 && begin < 0 ? parts : undefined;
}

/** Where the text of an element begins and ends, and whether it is in CDATA. */
function content(xml: string, begin: number, end: number): [number, number, boolean] | undefined {
  const written = xml.slice(begin, end);
  const open = written.indexOf("<![CDATA[");
  if (open < 0) return written.includes("<") ? undefined : [begin, end, false];
  const close = written.lastIndexOf("]]>");
  const inner = written.slice(open + 9, close);
  const isAlone = written.slice(0, open).trim() === "" && written.slice(close + 3).trim() === "";
  if (!isAlone || inner.replaceAll(SPLIT, "").includes("]]>")) return undefined;
  return [begin + open + 9, begin + close, true];
}

/** A text as the programmer writes it. */
function plain(written: string, isCdata: boolean): string {
  const text = written.replaceAll("\r\n", "\n");
  if (isCdata) return text.replaceAll(SPLIT, "]]>");
  return text.replace(/&(?:#(\d+)|#x([\da-f]+)|(\w+));/gi, (whole, decimal, hex, name) =>
    decimal || hex ? String.fromCodePoint(decimal ? Number(decimal) : parseInt(hex, 16)) : ENTITIES[name] ?? whole);
}

function heading(title: Title, language: Language): string {
  const words = language === "de" ? ["Deklaration", "Implementierung"] : ["declaration", "implementation"];
  return `// ════ ${title.name} · ${words[title.isDeclaration ? 0 : 1]} ════`;
}

/** The texts of a file, each below a heading. */
export function shown(parts: Parts, language: Language): string {
  return parts.texts
    .map((text, index) => `${heading(parts.titles[index]!, language)}\n${plain(text, parts.isCdata[index]!)}`)
    .join("\n");
}

/** The parts with the texts of what is shown; throws `HeadingError`. Texts that are the same stay as written. */
export function taken(parts: Parts, text: string, language: Language): Parts {
  const lines = text.split(/\r?\n/);
  const places = parts.titles.map((title) => {
    const wanted = heading(title, language);
    const found = lines.flatMap((line, index) => (line === wanted ? [index] : []));
    if (found.length !== 1) throw new HeadingError(wanted);
    return found[0]!;
  });
  places.forEach((place, index) => {
    if (place < (index ? places[index - 1]! + 1 : 0)) throw new HeadingError(lines[place]!);
  });
  if (places[0] !== 0) throw new HeadingError(lines[places[0]!]!);
  const end = parts.between.some((one) => one.includes("\r\n")) ? "\r\n" : "\n";
  const texts = parts.texts.map((before, index) => {
    const now = lines.slice(places[index]! + 1, places[index + 1]).join("\n");
    const isCdata = parts.isCdata[index]!;
    if (now === plain(before, isCdata)) return before;
    const safe = isCdata
      ? now.replaceAll("]]>", SPLIT)
      : now.replace(/[<>&]/g, (sign) => ({ "<": "&lt;", ">": "&gt;", "&": "&amp;" })[sign]!);
    return safe.replaceAll("\n", end);
  });
  return { ...parts, texts };
}

/** The whole file. */
export function composed(parts: Parts): string {
  return parts.texts.map((text, index) => parts.between[index]! + text).join("") + parts.between.at(-1)!;
}

/** Where each line that is shown lies in the file. */
export class Lines {
  /** Line and column in the file by lines that are shown; nothing for headings. */
  private readonly places: (Place | undefined)[] = [];
  private readonly lengths: number[] = [];

  constructor(parts: Parts) {
    let line = 0;
    let character = 0;
    const pass = (text: string): void => {
      const lines = text.split("\n");
      line += lines.length - 1;
      character = lines.length > 1 ? lines.at(-1)!.length : character + text.length;
    };
    parts.texts.forEach((text, index) => {
      pass(parts.between[index]!);
      this.places.push(undefined);
      this.lengths.push(0);
      text.split("\n").forEach((own, number) => {
        this.places.push({ line: line + number, character: number ? 0 : character });
        this.lengths.push(own.replace(/\r$/, "").length);
      });
      pass(text);
    });
  }

  /** A place in the file for one that is shown; of a heading the beginning of its text. */
  toFile(place: Place): Place {
    const found = this.places[place.line] ?? this.places[place.line + 1] ?? this.places.at(-1)!;
    const character = this.places[place.line] === undefined ? 0 : place.character;
    return { line: found.line, character: found.character + character };
  }

  /** The last line that is shown of a line of the file: a statement stands after the markup. */
  lastIn(line: number): Place | undefined {
    const index = this.places.findLastIndex((own) => own?.line === line);
    return index < 0 ? undefined : { line: index, character: 0 };
  }

  /** The place that is shown for one in the file; nothing outside of all texts. */
  toShown(place: Place): Place | undefined {
    for (let index = this.places.length - 1; index >= 0; index -= 1) {
      const own = this.places[index];
      if (own === undefined || own.line !== place.line || own.character > place.character) continue;
      const character = place.character - own.character;
      return character <= this.lengths[index]! ? { line: index, character } : undefined;
    }
    return undefined;
  }
}
