// A headless Chromium, driven through its own protocol over a pipe:
// open() gives a page with what a check needs.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const names = ["chromium", "chromium-browser", "google-chrome"];

export async function start() {
  const profile = mkdtempSync(join(tmpdir(), "web-check-"));
  const browser = spawn(process.env.CHROMIUM || names[0], ["--headless=new",
    "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe",
    "--hide-scrollbars", "--user-data-dir=" + profile, "about:blank"],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
  const [to, from] = [browser.stdio[3], browser.stdio[4]];
  const waiting = new Map(), listeners = new Set();
  let rest = "", last = 0;
  from.setEncoding("utf8");
  from.on("data", (chunk) => {
    const messages = (rest + chunk).split("\0");
    rest = messages.pop();
    for (const text of messages) {
      const m = JSON.parse(text);
      if (m.id) {
        const { resolve, reject } = waiting.get(m.id);
        waiting.delete(m.id);
        if (m.error) reject(new Error(m.error.message)); else resolve(m.result);
      } else {
        for (const l of listeners) l(m);
      }
    }
  });
  function send(method, params = {}, sessionId) {
    return new Promise((resolve, reject) => {
      waiting.set(++last, { resolve, reject });
      to.write(JSON.stringify({ id: last, method, params, sessionId }) + "\0");
    });
  }
  async function close() {
    const ended = new Promise((resolve) => browser.on("exit", resolve));
    send("Browser.close").catch(() => {});
    await ended;
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
  return { open: () => open(send, listeners), close };
}

// A page: what it complained about and asked for is in `complaints` and
// `requests`.
async function open(send, listeners) {
  const { targetId } = await send("Target.createTarget", { url: "about:blank" });
  const { sessionId } = await send("Target.attachToTarget",
    { targetId, flatten: true });
  const page = { complaints: [], requests: [] };
  let loaded = null;
  listeners.add((m) => {
    if (m.sessionId !== sessionId) return;
    if (m.method === "Page.loadEventFired" && loaded) loaded();
    if (m.method === "Network.requestWillBeSent") {
      page.requests.push(m.params.request.url);
    }
    if (m.method === "Runtime.exceptionThrown") {
      page.complaints.push(m.params.exceptionDetails.exception?.description
        || m.params.exceptionDetails.text);
    }
    if (m.method === "Log.entryAdded" && m.params.entry.level === "error") {
      page.complaints.push(m.params.entry.text + " " + (m.params.entry.url || ""));
    }
    if (m.method === "Runtime.consoleAPICalled" && m.params.type === "error") {
      page.complaints.push(m.params.args.map((a) => a.value).join(" "));
    }
  });
  page.send = (method, params) => send(method, params, sessionId);
  for (const part of ["Page", "Network", "Runtime", "Log"]) {
    await page.send(part + ".enable");
  }
  page.go = async (url) => {
    page.complaints.length = page.requests.length = 0;
    const done = new Promise((resolve) => { loaded = resolve; });
    await page.send("Page.navigate", { url });
    await done;
  };
  page.size = (width, height = 900) => page.send(
    "Emulation.setDeviceMetricsOverride",
    { width, height, deviceScaleFactor: 1, mobile: false });
  page.scheme = (value) => page.send("Emulation.setEmulatedMedia",
    { features: [{ name: "prefers-color-scheme", value }] });
  page.evaluate = async (expression) => {
    const r = await page.send("Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true });
    if (r.exceptionDetails) {
      throw new Error(r.exceptionDetails.exception?.description);
    }
    return r.result.value;
  };
  page.picture = async (whole = false) => {
    const r = await page.send("Page.captureScreenshot",
      { format: "png", captureBeyondViewport: whole });
    return Buffer.from(r.data, "base64");
  };
  page.key = async (key, code = key, text) => {
    const keyCode = { Enter: 13, " ": 32, Tab: 9, ArrowLeft: 37, ArrowUp: 38,
      ArrowRight: 39, ArrowDown: 40 }[key] || key.toUpperCase().charCodeAt(0);
    const k = { key, code, windowsVirtualKeyCode: keyCode,
      text: text ?? (key === "Enter" ? "\r" : key.length === 1 ? key : undefined) };
    await page.send("Input.dispatchKeyEvent", { type: "keyDown", ...k });
    await page.send("Input.dispatchKeyEvent", { type: "keyUp", ...k });
  };
  page.click = async (x, y) => {
    for (const type of ["mousePressed", "mouseReleased"]) {
      await page.send("Input.dispatchMouseEvent",
        { type, x, y, button: "left", clickCount: 1 });
    }
  };
  return page;
}
