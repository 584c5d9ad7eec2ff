// SPDX-License-Identifier: MIT
// What a worker of startWorker() runs: its first message is the port to serve.
import {serve} from "./worker-thread.mjs";

if (typeof self === "object" && "postMessage" in self) {
  self.addEventListener("message", ({data}) => serve(data), {once: true});
} else {
  // @ts-expect-error nothing else needs the types of Node
  const {parentPort} = await import("node:worker_threads");
  parentPort.once("message", serve);
}
