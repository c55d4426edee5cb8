// The search runs in a worker, which browsers refuse to pages that are opened from a folder: there a hidden frame does its work.
if (location.protocol === "file:") {
  window.Worker = class extends EventTarget {
    constructor(address) {
      super();
      const frame = document.createElement("iframe");
      frame.hidden = true;
      frame.title = "Search";
      document.body.append(frame);
      const scope = frame.contentWindow;
      // What the worker's script calls to answer.
      scope.postMessage = (data) => this.dispatchEvent(new MessageEvent("message", { data }));
      const script = scope.document.createElement("script");
      this.scope = new Promise((resolve, reject) => {
        script.onload = () => resolve(scope);
        script.onerror = () => reject(new Error(`${address} cannot be loaded`));
      });
      script.src = new URL(address, location.href).href;
      scope.document.body.append(script);
    }

    postMessage(data) {
      this.scope.then((scope) => scope.dispatchEvent(new MessageEvent("message", { data })));
    }
  };
}
