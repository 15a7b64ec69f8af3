// SPDX-License-Identifier: MIT
// The client of both servers of nctakt: the language server and the debug adapter.

import { spawn, type ChildProcess } from "node:child_process";
import * as path from "node:path";
import * as vscode from "vscode";
import { LanguageClient, type ServerOptions } from "vscode-languageclient/node";
import { tracker } from "./debugging";
import { language, middleware, register as registerObjects } from "./shown";

const LANGUAGES = ["nctakt", "nctakt-list", "nctakt-st"];
let client: LanguageClient | undefined;
let page: ChildProcess | undefined;

function settings(): vscode.WorkspaceConfiguration {
  return vscode.workspace.getConfiguration("nctakt");
}

/** The words that start nctakt; a relative path is one of the first folder. */
function words(): [string, string[]] {
  const named = settings().get<string | string[]>("command", ["nctakt"]);
  const [command = "nctakt", ...rest] = typeof named === "string" ? [named] : named;
  const folder = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath;
  const isRelative = command.includes("/") && !path.isAbsolute(command) && folder !== undefined;
  return [isRelative ? path.join(folder, command) : command, rest];
}

/** The environment of what is started: Python imports no modules of the folder it starts in. */
function environment(): Record<string, string> {
  const own: Record<string, string> = { PYTHONSAFEPATH: "1" };
  for (const [name, value] of Object.entries(process.env)) {
    if (value !== undefined && !(name in own)) own[name] = value;
  }
  return own;
}

async function startClient(): Promise<void> {
  const [command, rest] = words();
  const server: ServerOptions = { command, args: [...rest, "lsp"], options: { env: environment() } };
  const others = settings().get<string[]>("languages", []);
  client = new LanguageClient("nctakt", "nctakt", server, {
    documentSelector: [...LANGUAGES, ...others].map((language) => ({ language })),
    initializationOptions: {
      language: language(),
      reference: settings().get<string>("reference", ""),
    },
    synchronize: {
      fileEvents: vscode.workspace.createFileSystemWatcher(
        "**/*.{lis,xml,nc,toml,st,iecst,TcPOU,TcDUT,TcGVL,TcIO,TcTTO,plcproj}",
      ),
    },
    middleware,
  });
  try {
    await client.start();
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    void vscode.window.showErrorMessage(
      vscode.l10n.t(
        'nctakt could not be started ({0}): {1}. Install it with its extra "editor", and name it in the setting nctakt.command.',
        [command, ...rest].join(" "),
        reason,
      ),
    );
  }
}

/** The program that a command is about: its argument, else the one in the editor. */
async function program(uri: unknown): Promise<string | undefined> {
  const target =
    typeof uri === "string"
      ? vscode.Uri.parse(uri)
      : uri instanceof vscode.Uri
        ? uri
        : vscode.window.activeTextEditor?.document.uri;
  if (target === undefined || target.scheme !== "file") {
    void vscode.window.showWarningMessage(vscode.l10n.t("Open an NC program first."));
    return undefined;
  }
  await vscode.workspace.textDocuments.find((one) => one.uri.fsPath === target.fsPath)?.save();
  return target.fsPath;
}

async function inTerminal(name: string, uri: unknown): Promise<void> {
  const file = await program(uri);
  if (file === undefined) return;
  const [command, rest] = words();
  const terminal = vscode.window.createTerminal({
    name: `nctakt ${name}`,
    cwd: path.dirname(file),
    shellPath: command,
    shellArgs: [...rest, name, file],
    env: { PYTHONSAFEPATH: "1" },
    isTransient: true,
  });
  terminal.show(true);
}

async function debug(uri: unknown): Promise<void> {
  const file = await program(uri);
  if (file === undefined) return;
  await vscode.debug.startDebugging(undefined, {
    type: "nctakt",
    request: "launch",
    name: path.basename(file),
    program: file,
    stopOnEntry: true,
  });
}

/** Show the page of a session, with the trace of its run, in a panel beside the program. */
async function live(uri: unknown): Promise<void> {
  const file = await program(uri);
  if (file === undefined) return;
  page?.kill();
  const [command, rest] = words();
  const options = { cwd: path.dirname(file), env: environment() };
  const running = spawn(command, [...rest, "live", file, "--port", "0", "--embed"], options);
  page = running;
  let shown = false;
  let complaint = "";
  running.stderr.on("data", (data: Buffer) => (complaint += data.toString()));
  running.on("error", (error) => void vscode.window.showErrorMessage(error.message));
  running.on("exit", (code) => {
    if (code && !shown) void vscode.window.showErrorMessage(complaint || vscode.l10n.t("nctakt ended with {0}", code));
  });
  running.stdout.on("data", (data: Buffer) => {
    const address = /https?:\/\/\S+/.exec(data.toString())?.[0];
    if (address === undefined || shown) return;
    shown = true;
    const beside = vscode.ViewColumn.Beside;
    const panel = vscode.window.createWebviewPanel("nctakt", path.basename(file), beside, {
      enableScripts: true,
      retainContextWhenHidden: true,
    });
    const origin = new URL(address).origin;
    panel.webview.html =
      `<meta http-equiv="Content-Security-Policy" content="default-src 'none'; frame-src ${origin}; style-src 'unsafe-inline'">` +
      `<style>html,body,iframe{margin:0;border:0;padding:0;width:100%;height:100vh}</style>` +
      `<iframe src="${address}"></iframe>`;
    panel.onDidDispose(() => running.kill());
  });
}

/** Let files that end as this one be NC programs or lists of nctakt, in this workspace. */
async function associate(): Promise<void> {
  const document = vscode.window.activeTextEditor?.document;
  const suffix = document === undefined ? "" : path.extname(document.fileName);
  if (document === undefined || suffix === "") return;
  const language = suffix.toLowerCase() === ".lis" ? "nctakt-list" : "nctakt";
  const files = vscode.workspace.getConfiguration("files");
  const known = files.get<Record<string, string>>("associations", {});
  const associations = { ...known, [`*${suffix}`]: language };
  const target = vscode.workspace.workspaceFolders
    ? vscode.ConfigurationTarget.Workspace
    : vscode.ConfigurationTarget.Global;
  await files.update("associations", associations, target);
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const register = (name: string, action: (...words: unknown[]) => unknown): void => {
    context.subscriptions.push(vscode.commands.registerCommand(name, action));
  };
  register("nctakt.run", (uri) => inTerminal("run", uri));
  register("nctakt.why", (uri) => inTerminal("why", uri));
  register("nctakt.debug", debug);
  register("nctakt.live", live);
  register("nctakt.associate", associate);
  register("nctakt.restart", async () => {
    await client?.stop();
    await startClient();
  });
  const factory: vscode.DebugAdapterDescriptorFactory = {
    createDebugAdapterDescriptor: () => {
      const [command, rest] = words();
      return new vscode.DebugAdapterExecutable(command, [...rest, "dap"], { env: environment() });
    },
  };
  context.subscriptions.push(
    vscode.debug.registerDebugAdapterDescriptorFactory("nctakt", factory),
    vscode.debug.registerDebugAdapterTrackerFactory("nctakt", tracker),
    new vscode.Disposable(() => page?.kill()),
  );
  registerObjects(context);
  await startClient();
}

export async function deactivate(): Promise<void> {
  page?.kill();
  await client?.stop();
}
