// SPDX-License-Identifier: MIT
// ads-client reads, writes, uploads and listens to a PLC: node drive_ads_plc.js HOST PORT NETID
"use strict";

const assert = require("node:assert");
const { Client } = require("ads-client");

async function main([host, port, netId]) {
  const client = new Client({
    targetAmsNetId: netId,
    targetAdsPort: 851,
    routerAddress: host,
    routerTcpPort: Number(port),
    localAmsNetId: "10.0.0.9.1.1",
    localAdsPort: 32751,
    timeoutDelay: 20000,
  });
  await client.connect();

  assert.deepStrictEqual((await client.readValue("MAIN.aMatrix")).value.flat(9), [1, 2, 3, 4, 5, 6]);
  assert.strictEqual(String((await client.readValue("MAIN.nBig")).value), "-5000000000");
  assert.strictEqual((await client.readValue("MAIN.fReal")).value, 0.5);
  assert.strictEqual((await client.readValue("MAIN.aTools[1].sName")).value, "drill");

  const symbols = await client.getSymbols();
  assert.strictEqual(symbols["main.fbgate"].type, "FB_Gate");
  assert.strictEqual(symbols["main.atools"].type, "ARRAY [1..2] OF ST_Tool");
  assert.ok((await client.getDataTypes())["e_gate"]);

  const seen = [];
  const listen = (data) => seen.push(data.value);
  const subscription = await client.subscribeValue("MAIN.bGate", listen, 10);
  await client.writeValue("MAIN.bGate", true);
  const end = Date.now() + 20000;
  while (!seen.includes(true) && Date.now() < end) {
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  assert.ok(seen.includes(true));
  await subscription.unsubscribe();
  while ((await client.readRawByPath("MAIN.fbGate.eState")).readInt16LE(0) !== 5) {
    assert.ok(Date.now() < end);
  }

  await client.writeValue("MAIN.aTools[2].sName", "bit");
  assert.strictEqual((await client.readValue("MAIN.aTools[2].sName")).value, "bit");
  const handle = await client.createVariableHandle("MAIN.nBig");
  assert.strictEqual((await client.readRawByHandle(handle)).readBigInt64LE(0), -5000000000n);
  await client.deleteVariableHandle(handle);
  await assert.rejects(client.createVariableHandle("MAIN.fbGate#Open"));
  await client.disconnect();
}

main(process.argv.slice(2)).catch((error) => {
  console.error(error);
  process.exit(1);
});
