// SPDX-License-Identifier: MIT
// Drives the debugger with the client of VS Code: node drive.js PYTHON ADAPTER.py PROGRAM.nc
// Prints a line for each scenario that has passed.
"use strict";

const assert = require("assert");
const { DebugClient } = require("@vscode/debugadapter-testsupport");

const [python, adapter, program] = process.argv.slice(2);

async function inDebugger(scenario) {
  const client = new DebugClient(python, adapter, "nctakt", { stdio: "pipe" });
  client.defaultTimeout = 20000;
  await client.start();
  try {
    await scenario(client);
  } finally {
    await client.stop();
  }
}

async function begun(client, settings) {
  await Promise.all([client.waitForEvent("initialized"), client.launch({ program, ...settings })]);
}

function line(frames) {
  return frames.body.stackFrames[0].line;
}

const scenarios = {
  async "stops, steps, goes back"(client) {
    await begun(client, {});
    const asked = { source: { path: program }, breakpoints: [{ line: 9 }, { line: 10 }] };
    const set = await client.setBreakpointsRequest(asked);
    assert.deepStrictEqual(set.body.breakpoints.map((one) => one.verified), [true, true]);
    await Promise.all([
      client.configurationDoneRequest(),
      client.assertStoppedLocation("breakpoint", { path: program, line: 9 }),
    ]);
    await Promise.all([
      client.continueRequest({ threadId: 1 }),
      client.assertStoppedLocation("breakpoint", { line: 10 }),
    ]);
    await Promise.all([
      client.reverseContinueRequest({ threadId: 1 }),
      client.assertStoppedLocation("breakpoint", { line: 9 }),
    ]);
    await Promise.all([
      client.nextRequest({ threadId: 1 }),
      client.assertStoppedLocation("breakpoint", { line: 10 }),
    ]);
    await Promise.all([
      client.stepBackRequest({ threadId: 1 }),
      client.assertStoppedLocation("step", { line: 9 }),
    ]);
    const said = await client.evaluateRequest({ expression: "tick", context: "repl" });
    assert.match(said.body.result, /^before tick/);
  },

  async "stops in realtime cycles, at functions, at data, at messages"(client) {
    await begun(client, { stopOnEntry: true, at: [["5 ms", "V.E.VALUE1=1"]] });
    const branch = { line: 3, condition: "changes" };
    await client.setBreakpointsRequest({ source: { path: program }, breakpoints: [branch] });
    await client.setFunctionBreakpointsRequest({ breakpoints: [{ name: "M100" }] });
    const info = await client.dataBreakpointInfoRequest({ name: "V.E.VALUE1" });
    const data = { dataId: info.body.dataId };
    await client.setDataBreakpointsRequest({ breakpoints: [data] });
    await client.setExceptionBreakpointsRequest({ filters: ["message"] });
    const reasons = [];
    let stop = client.waitForEvent("stopped");
    await client.configurationDoneRequest();
    for (let count = 0; count < 6; count++) {
      reasons.push((await stop).body.reason);
      stop = client.waitForEvent("stopped");
      await client.continueRequest({ threadId: 1 });
    }
    await stop;
    assert.deepStrictEqual(reasons, [
      "entry",
      "data breakpoint",
      "breakpoint",
      "breakpoint",
      "exception",
      "function breakpoint",
    ]);
  },

  async "shows and sets variables"(client) {
    await begun(client, { stopOnEntry: true });
    await Promise.all([client.configurationDoneRequest(), client.waitForEvent("stopped")]);
    const frames = await client.stackTraceRequest({ threadId: 1 });
    const frameId = frames.body.stackFrames[0].id;
    const { scopes } = (await client.scopesRequest({ frameId })).body;
    const own = scopes.find((one) => one.name === "V.E").variablesReference;
    await client.setVariableRequest({ variablesReference: own, name: "COUNT", value: "7" });
    await Promise.all([
      client.waitForEvent("stopped"),
      client.customRequest("next", { threadId: 1, granularity: "instruction" }),
    ]);
    const seen = await client.evaluateRequest({ expression: "V.E.COUNT", context: "watch" });
    assert.strictEqual(seen.body.result, "7");
  },

  async "runs to the end without stops"(client) {
    await begun(client, { noDebug: true });
    await Promise.all([client.configurationDoneRequest(), client.waitForEvent("terminated")]);
  },
};

(async () => {
  for (const [name, scenario] of Object.entries(scenarios)) {
    await inDebugger(scenario);
    console.log(name);
  }
})().catch((error) => {
  console.error(error);
  process.exit(1);
});
