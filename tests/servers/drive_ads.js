// SPDX-License-Identifier: MIT
// ads-client reads, writes, uploads and listens: node drive_ads.js HOST PORT NETID
"use strict";

const assert = require("node:assert");
const { Client } = require("ads-client");

async function main([host, port, netId]) {
  const client = new Client({
    targetAmsNetId: netId,
    targetAdsPort: 851,
    routerAddress: host,
    routerTcpPort: Number(port),
    localAmsNetId: "10.0.0.7.1.1",
    localAdsPort: 32750,
    timeoutDelay: 20000,
  });
  await client.connect();

  await client.writeValue("V.E.COUNT", 12);
  assert.strictEqual((await client.readValue("V.E.COUNT")).value, 12);

  const before = (await client.readValue("V.E.LEVEL_1_A[1]")).value;
  assert.deepStrictEqual(before.LEVEL_2_A[1].LIST, [0, 0, 0, 0]);
  const changed = { ...before, UNS32: 99, STRING: "abc" };
  changed.LEVEL_2_A[1].LIST[2] = -5;
  await client.writeValue("V.E.LEVEL_1_A[1]", changed);
  const all = (await client.readValue("V.E.LEVEL_1_A")).value;
  assert.deepStrictEqual(all[1], changed);
  assert.strictEqual(all[0].UNS32, 0);

  const list = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10];
  await client.writeValue("V.E.LIST", list);
  assert.deepStrictEqual((await client.readValue("V.E.LIST")).value, list);

  const channel = "HLI_Global_Variables.gpCh[0]^";
  const state = (await client.readValue(`${channel}.channel_mc_control.mode_and_state.state_r`)).value;
  assert.strictEqual(state.mode, 2);
  await client.writeValue(`${channel}.hb_mc_control.rapid_key.command_w.log_key_nr`, 3);
  const key = (await client.readValue(`${channel}.hb_mc_control.rapid_key.command_w`)).value;
  assert.strictEqual(key.log_key_nr, 3);

  const symbols = await client.getSymbols();
  assert.strictEqual(symbols["v.e.list"].type, "ARRAY [0..9] OF LREAL");
  const types = await client.getDataTypes();
  assert.ok(types["level_1"]);

  const seen = [];
  const subscription = await client.subscribeValue("V.E.COUNT", (data) => seen.push(data.value), 10);
  await client.writeValue("V.E.COUNT", 13);
  const end = Date.now() + 20000;
  while (!seen.includes(13) && Date.now() < end) {
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  assert.strictEqual(seen[seen.length - 1], 13);
  await subscription.unsubscribe();

  const handle = await client.createVariableHandle("V.E.COUNT");
  assert.strictEqual((await client.readRawByHandle(handle)).readUInt32LE(0), 13);
  await client.deleteVariableHandle(handle);
  assert.strictEqual((await client.readState()).adsStateStr, "Run");
  await client.disconnect();
}

main(process.argv.slice(2)).catch((error) => {
  console.error(error);
  process.exit(1);
});
