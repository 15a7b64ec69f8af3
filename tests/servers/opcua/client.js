// SPDX-License-Identifier: MIT
// A client by node-opcua: reads, subscribes, writes, calls, hears an alarm, acknowledges it, reads
// the past. Prints one JSON object. Arguments: URL, program with an error, user, password.
"use strict";

const opcua = require("node-opcua");

const [url, program, user, password] = process.argv.slice(2);
const CHANNEL = "ns=3;s=CncChannelList.1";

async function until(what, condition) {
  for (let count = 0; count < 2000; count += 1) {
    const found = await condition();
    if (found) return found;
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
  throw new Error(`never came: ${what}`);
}

async function main() {
  const words = { endpointMustExist: false, connectionStrategy: { maxRetry: 1 } };
  if (user) {
    words.securityMode = opcua.MessageSecurityMode.SignAndEncrypt;
    words.securityPolicy = opcua.SecurityPolicy.Basic256Sha256;
  }
  const client = opcua.OPCUAClient.create(words);
  await client.connect(url);
  const identity = user
    ? { type: opcua.UserTokenType.UserName, userName: user, password }
    : undefined;
  const session = await client.createSession(identity);
  const value = async (nodeId) => (await session.read({ nodeId })).value.value;
  const call = async (name, inputArguments = []) =>
    session.call({ objectId: CHANNEL, methodId: `${CHANNEL}.${name}`, inputArguments });
  const told = {};

  told.position = (await value("ns=3;s=CncAxisList.X.PosDirect")).actPos;
  told.load = (await session.read({ nodeId: "ns=3;s=CncAxisList.X.ActLoad" })).statusCode.name;
  const unit = await value("ns=3;s=CncAxisList.X.PosDirect.EngineeringUnits");
  told.unit = unit.displayName.text;

  const tool = "ns=3;s=MachineTool";
  const browsed = await session.browse(tool);
  told.machine = browsed.references.map((one) => one.browseName.name).sort();
  const state = `${tool}.Production.ActiveProgram.State.CurrentState`;
  told.state = [(await value(state)).text, await value(`${state}.Number`)];
  told.feedUnit = (
    await value(`${tool}.Monitoring.Channel_1.FeedOverride.EngineeringUnits`)
  ).displayName.text;

  const subscription = await session.createSubscription2({
    requestedPublishingInterval: 50,
    requestedLifetimeCount: 100,
    requestedMaxKeepAliveCount: 10,
    publishingEnabled: true,
  });
  const seen = [];
  const item = await subscription.monitor(
    { nodeId: `${CHANNEL}.V.E.VALUE`, attributeId: opcua.AttributeIds.Value },
    { samplingInterval: 50, queueSize: 10, discardOldest: true },
    opcua.TimestampsToReturn.Both,
  );
  item.on("changed", (found) => seen.push(found.value.value));
  const status = await session.write({
    nodeId: `${CHANNEL}.V.E.VALUE`,
    attributeId: opcua.AttributeIds.Value,
    value: { value: { dataType: opcua.DataType.Double, value: 2.5 } },
  });
  told.write = status.name;
  await until("the value", () => seen.includes(2.5));
  told.seen = seen;

  const fields = ["EventId", "ConditionId", "AlarmIdentifier", "ActiveState.Id", "AckedState.Id"];
  const events = [];
  const alarms = await subscription.monitor(
    { nodeId: "ns=3;s=CncInterface", attributeId: opcua.AttributeIds.EventNotifier },
    { queueSize: 100, filter: opcua.constructEventFilter([...fields, "2:AlarmIdentifier"]) },
    opcua.TimestampsToReturn.Both,
  );
  alarms.on("changed", (found) => events.push(found.map((one) => one.value)));
  const alerts = [];
  const messages = await subscription.monitor(
    { nodeId: `${tool}.Notification.Messages`, attributeId: opcua.AttributeIds.EventNotifier },
    { queueSize: 100, filter: opcua.constructEventFilter(["Severity", "6:ErrorCode"]) },
    opcua.TimestampsToReturn.Both,
  );
  messages.on("changed", (found) => alerts.push(found.map((one) => one.value)));
  told.reset = (await call("Reset")).statusCode.name;
  const select = () => call("SelectProgram", [{ dataType: opcua.DataType.String, value: program }]);
  await until("the selection", async () => (await select()).statusCode.isGood());
  await until("readiness", () => value(`${CHANNEL}.HLI.ARMED`));
  told.start = (await call("Start")).statusCode.name;
  const alarm = await until("the alarm", () => events.find((one) => one[5] && one[3] === true));
  told.alarm = alarm[5];
  told.alert = await until("the alert", () => alerts.find((one) => one[1]));
  told.acknowledge = (await session.acknowledgeCondition(alarm[1], alarm[0], "seen")).name;
  await until("its acknowledgement", () => events.find((one) => one[4] === true));

  const end = new Date();
  const past = await session.readHistoryValue(
    "ns=3;s=CncAxisList.X.PosDirect.ActPos",
    new Date(end.getTime() - 60000),
    end,
    { numValuesPerNode: 50 },
  );
  told.past = past.historyData.dataValues.length;

  await subscription.terminate();
  await session.close();
  await client.disconnect();
  console.log(JSON.stringify(told));
}

main().then(
  () => process.exit(0),
  (error) => {
    console.error(error);
    process.exit(1);
  },
);
