// Figures that run: below a picture of the book, the same idea to be
// tried, computed by the book's own C. A figure is
//
//   live("ch04-count-scan-place", { title, ask, choices, because,
//                                   show(stage) })
//
// It asks for a prediction, one of the choices or else a number, and
// shows itself when there is one; because says what is right. show
// returns { check }, which computes the answer in another way and tells
// whether both are equal. Without WebAssembly the picture stands alone.
//
// What changes is said: the answer to the prediction, the status, and
// what a key did are live regions, there before anything is said. What
// cannot be pressed any more keeps the focus.
"use strict";

var live = (function () {
  var compiled = null; // a promise of the module
  var here = document.currentScript.src.replace(/[^/]*$/, "");

  function element(name, attributes, children) {
    var e = document.createElement(name);
    Object.keys(attributes || {}).forEach(function (key) {
      e.setAttribute(key, attributes[key]);
    });
    [].concat(children || []).forEach(function (c) { e.append(c); });
    return e;
  }

  // ---- the C ------------------------------------------------------------
  // near.js holds the module as text, so that a page that is a file can
  // load it: it sets live.module.
  function module() {
    compiled = compiled || new Promise(function (resolve, reject) {
      var script = element("script", { src: here + "near.js" });
      script.onload = resolve;
      script.onerror = function () { reject(new Error("no near.js")); };
      document.head.append(script);
    }).then(function () {
      var text = atob(live.module), bytes = new Uint8Array(text.length);
      for (var i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
      return WebAssembly.compile(bytes);
    });
    return compiled;
  }

  // What C's library asks of a system: a clock, and where its last words
  // go. A program that ends says why in them.
  function system(memory) {
    var said = "";
    function view() { return new DataView(memory().buffer); }
    return {
      environ_get: function () { return 0; },
      environ_sizes_get: function (count, size) {
        view().setUint32(count, 0, true);
        view().setUint32(size, 0, true);
        return 0;
      },
      clock_time_get: function (id, precision, to) {
        view().setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)),
          true);
        return 0;
      },
      fd_close: function () { return 8; },
      fd_fdstat_get: function () { return 8; },
      fd_seek: function () { return 8; },
      fd_write: function (file, parts, count, written) {
        var sum = 0;
        for (var i = 0; i < count; i++) {
          var at = view().getUint32(parts + 8 * i, true);
          var length = view().getUint32(parts + 8 * i + 4, true);
          said += new TextDecoder().decode(
            new Uint8Array(memory().buffer, at, length));
          sum += length;
        }
        view().setUint32(written, sum, true);
        return 0;
      },
      proc_exit: function () { throw new Error(said.trim()); }
    };
  }

  // An instance with a memory of its own: C's functions by their names,
  // and arrays that are copied out of it.
  function instance(m) {
    var c, memory = function () { return c.memory.buffer && c.memory; };
    c = new WebAssembly.Instance(m,
      { wasi_snapshot_preview1: system(memory) }).exports;
    c._initialize();
    var wrapped = Object.create(c);
    wrapped.text = function (bytes) {
      if (typeof bytes === "string") bytes = new TextEncoder().encode(bytes);
      var at = c.room(bytes.length);
      new Uint8Array(c.memory.buffer, at, bytes.length).set(bytes);
      return at;
    };
    wrapped.u32 = function (at, n) {
      return new Uint32Array(c.memory.buffer, at, n).slice();
    };
    wrapped.f64 = function (at, n) {
      return new Float64Array(c.memory.buffer, at, n).slice();
    };
    wrapped.points = function (list) { // [[x, y], ...]
      c.set_points(list.length);
      var x = new Float64Array(c.memory.buffer, c.x(), list.length);
      var y = new Float64Array(c.memory.buffer, c.y(), list.length);
      list.forEach(function (p, i) { x[i] = p[0]; y[i] = p[1]; });
    };
    wrapped.generate = function (kind, n, seed) {
      c.generate_points(wrapped.text(kind), n, seed);
      var x = wrapped.f64(c.x(), n), y = wrapped.f64(c.y(), n);
      return Array.from(x, function (v, i) { return [v, y[i]]; });
    };
    wrapped.by = function (name) { c.ask(wrapped.text(name)); };
    return wrapped;
  }

  // ---- the frame -----------------------------------------------------------
  function enable(button, able) {
    button.setAttribute("aria-disabled", String(!able));
  }

  // The same words again are said again only if they differ.
  function say(region, text) {
    var again = text && region.textContent === text;
    region.textContent = again ? text + "\u00a0" : text;
  }

  function controls(stage) {
    stage.button = function (label, act) {
      var b = element("button", { type: "button" }, label);
      b.addEventListener("click", function () {
        if (b.getAttribute("aria-disabled") !== "true") act();
      });
      stage.panel.append(b);
      return b;
    };
    stage.enable = enable;
    stage.choice = function (label, names, act) {
      var select = element("select", {}, names.map(function (n) {
        return element("option", {}, n);
      }));
      select.addEventListener("change", function () {
        act(select.selectedIndex);
      });
      stage.panel.append(element("label", {}, [label + " ", select]));
      return select;
    };
    stage.say = function (text) { stage.status.textContent = text; };
    stage.tell = function (text) { say(stage.told, text); };
    return stage;
  }

  // The prediction: one of some answers, or a number. What is wrong with
  // it is said in the answer's place.
  function prediction(figure, name, answer, predicted) {
    var form = element("form", { "class": "predict", novalidate: "" });
    var set = element("fieldset", {}, element("legend", {}, figure.ask));
    if (figure.choices) {
      figure.choices.forEach(function (text, i) {
        set.append(element("label", {}, [element("input", { type: "radio",
          name: "predict-" + name, value: i }), " " + text]));
      });
    } else {
      set.append(element("label", {}, ["Your number: ", element("input",
        { type: "text", inputmode: "decimal", autocomplete: "off" })]));
    }
    var button = element("button", { type: "submit" }, "Show");
    form.append(set, button);
    form.addEventListener("submit", function (event) {
      event.preventDefault();
      if (button.getAttribute("aria-disabled") === "true") return;
      var chosen = form.querySelector("input:checked, input[type=text]");
      if (!chosen) return say(answer, "Choose one of the answers first.");
      var text = chosen.value.trim(), wrong = text === "" || isNaN(text);
      if (!figure.choices) chosen.setAttribute("aria-invalid", String(wrong));
      if (wrong) {
        return say(answer, text === "" ? "Give a number first."
          : "“" + text + "” is not a number, such as 12 or 0.5.");
      }
      enable(button, false);
      form.querySelectorAll("input").forEach(function (e) {
        e.readOnly = true;
        e.disabled = e !== chosen;
      });
      predicted(Number(text));
    });
    return form;
  }

  function show(figure, name, frame, stage) {
    var value = stage.predicted;
    say(stage.answer, figure.because ? "You said " + (figure.choices
      ? "“" + figure.choices[value] + "”" : value) + ". " + figure.because : "");
    stage.answer.after(stage.box, stage.panel);
    stage.say("Loading the book's C.");
    return module().then(function (m) {
      stage.c = instance(m);
      stage.fresh = function () { stage.c = instance(m); return stage.c; };
      stage.say("");
      live.shown[name] = figure.show(stage);
      frame.dataset.shown = "yes";
    }).catch(function (error) {
      stage.say("This figure cannot run here: " + error.message);
    });
  }

  function begin(name, figure) {
    var picture = document.querySelector('figure[data-figure="' + name + '"]');
    if (!picture || typeof WebAssembly !== "object") return;
    var title = element("p", { "class": "live-title", id: "live-" + name },
      "Try it: " + figure.title);
    var frame = element("div", { "class": "live", role: "group",
      "aria-labelledby": "live-" + name }, title);
    var stage = controls({ box: element("div", { "class": "stage" }),
      panel: element("div", { "class": "panel" }),
      answer: element("p", { "class": "because", "aria-live": "polite" }),
      status: element("p", { role: "status" }),
      told: element("p", { "class": "unseen", "aria-live": "polite" }) });
    frame.append(prediction(figure, name, stage.answer, function (value) {
      stage.predicted = value;
      show(figure, name, frame, stage);
    }), stage.answer, stage.status, stage.told);
    picture.after(frame);
  }

  begin.element = element;
  begin.shown = {}; // what runs, for the tests
  return begin;
})();
