// What the figures that run are drawn with: SVG in the page's colors, a
// plane on which points are put with the mouse or with the keys, rows
// of boxes, a walk through steps, and all of it in words.
"use strict";

var draw = (function () {
  var SVG = "http://www.w3.org/2000/svg";

  function shape(name, attributes, text) {
    var e = document.createElementNS(SVG, name);
    Object.keys(attributes).forEach(function (key) {
      e.setAttribute(key, attributes[key]);
    });
    if (text !== undefined) e.textContent = text;
    return e;
  }

  // A picture of this size. Its name is what it shows at all, and what
  // it shows now, which tell() adds in words.
  function picture(stage, width, height, label) {
    var now = label;
    var svg = shape("svg", { viewBox: "0 0 " + width + " " + height,
      role: "img", "aria-label": label, width: width, height: height });
    stage.box.append(svg);
    return {
      svg: svg,
      clear: function () {
        svg.replaceChildren();
        svg.setAttribute("aria-label", now = label);
      },
      tell: function (words) {
        svg.setAttribute("aria-label", now += " " + words);
      },
      add: function (name, attributes, text) {
        var e = shape(name, attributes, text);
        svg.append(e);
        return e;
      },
      line: function (a, b, kind) {
        return this.add("line", { x1: a[0], y1: a[1], x2: b[0], y2: b[1],
          "class": kind });
      }
    };
  }

  // ---- in words -----------------------------------------------------------
  function place(q) {
    return "x " + q[0].toFixed(2) + ", y " + q[1].toFixed(2);
  }

  // A list that unfolds below the figure; it gets new lines by a call.
  function list(stage, title) {
    var items = live.element("ul");
    stage.status.after(live.element("details", {}, [
      live.element("summary", {}, title), items]));
    return function (lines) {
      items.replaceChildren.apply(items, lines.map(function (text) {
        return live.element("li", {}, text);
      }));
    };
  }

  // ---- a plane ------------------------------------------------------------
  // The unit square, y upward. act(x, y) is called for a click, and for
  // Enter or the space bar where the cross is, which the arrows move. It
  // returns in words what it did; where(q) has words for a place.
  var SIDE = 440, MARGIN = 10;

  function plane(stage, label, act, where) {
    var p = picture(stage, SIDE + 2 * MARGIN, SIDE + 2 * MARGIN, label);
    var cross = [0.5, 0.5], mark = null;
    p.at = function (q) {
      return [MARGIN + q[0] * SIDE, MARGIN + (1 - q[1]) * SIDE];
    };
    p.frame = function () {
      p.clear();
      p.add("rect", { x: MARGIN, y: MARGIN, width: SIDE, height: SIDE,
        "class": "box" });
    };
    p.dot = function (q, kind, radius) {
      var at = p.at(q);
      return p.add("circle", { cx: at[0], cy: at[1], r: radius || 3.5,
        "class": kind });
    };
    p.segment = function (a, b, kind) { return p.line(p.at(a), p.at(b), kind); };
    p.area = function (low, high, kind) {
      var a = p.at([low[0], high[1]]);
      return p.add("rect", { x: a[0], y: a[1], "class": kind,
        width: (high[0] - low[0]) * SIDE, height: (high[1] - low[1]) * SIDE });
    };
    p.circle = function (q, radius, kind) {
      var at = p.at(q);
      return p.add("circle", { cx: at[0], cy: at[1], r: radius * SIDE,
        "class": kind });
    };
    // Drawn last, above everything.
    p.cross = function () {
      var at = p.at(cross);
      mark = p.add("path", { d: "M" + (at[0] - 8) + " " + at[1] + "h16M" +
        at[0] + " " + (at[1] - 8) + "v16", "class": "cross" });
    };
    if (act) keys(p, cross, function (x, y) {
      stage.tell(act(x, y));
    }, function () {
      if (mark) mark.remove();
      p.cross();
      stage.tell("Cross at " + (where || place)(cross) + ".");
    });
    return p;
  }

  var moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1],
    ArrowDown: [0, -1] };

  function keys(p, cross, act, moved) {
    p.svg.setAttribute("tabindex", "0");
    p.svg.setAttribute("role", "application");
    p.svg.addEventListener("focus", moved);
    p.svg.classList.add("asks");
    p.svg.addEventListener("click", function (event) {
      var r = p.svg.getBoundingClientRect();
      var scale = (SIDE + 2 * MARGIN) / r.width;
      var x = ((event.clientX - r.left) * scale - MARGIN) / SIDE;
      var y = 1 - ((event.clientY - r.top) * scale - MARGIN) / SIDE;
      if (x >= 0 && x <= 1 && y >= 0 && y <= 1) act(x, y);
    });
    p.svg.addEventListener("keydown", function (event) {
      var move = moves[event.key], step = event.shiftKey ? 0.1 : 0.02;
      if (move) {
        cross[0] = Math.min(1, Math.max(0, cross[0] + move[0] * step));
        cross[1] = Math.min(1, Math.max(0, cross[1] + move[1] * step));
        moved();
      } else if (event.key === "Enter" || event.key === " ") {
        act(cross[0], cross[1]);
      } else return;
      event.preventDefault();
    });
  }

  // ---- rows of boxes ---------------------------------------------------------
  // Values side by side with their indices above; kinds[i] colors one.
  // The picture's name gets them, too.
  var BOX = 34;

  function boxes(p, x, y, values, options) {
    var o = options || {};
    p.tell((o.label ? o.label + ": " : "") + values.map(function (v) {
      return v === null ? "empty" : v;
    }).join(", ") + ".");
    if (o.label) {
      p.add("text", { x: x - 8, y: y + BOX * 0.64, "class": "row" }, o.label);
    }
    values.forEach(function (v, i) {
      p.add("rect", { x: x + i * BOX, y: y, width: BOX, height: BOX,
        "class": "cell " + (o.kinds && o.kinds[i] || "") });
      if (o.indices) {
        p.add("text", { x: x + (i + 0.5) * BOX, y: y - 5, "class": "index" }, i);
      }
      p.add("text", { x: x + (i + 0.5) * BOX, y: y + BOX * 0.64,
        "class": "value" }, v === null ? "" : v);
    });
  }

  // ---- steps ------------------------------------------------------------------
  // Buttons that walk through steps 0 .. last; to(k) draws step k.
  function steps(stage, last, to) {
    var now = 0;
    function go(k) {
      now = Math.max(0, Math.min(last(), k));
      stage.enable(back, now > 0);
      stage.enable(on, now < last());
      stage.enable(end, now < last());
      to(now);
    }
    var back = stage.button("Back", function () { go(now - 1); });
    var on = stage.button("Step", function () { go(now + 1); });
    var end = stage.button("To the end", function () { go(last()); });
    return { go: go, at: function () { return now; } };
  }

  // ---- words and points -------------------------------------------------------
  // One point, two points; more, where it is not one with an s.
  function many(n, one, more) {
    return n + " " + (n === 1 ? one : more || one + "s");
  }

  // The number of the point that is nearest to a place.
  function nearest(points, x, y) {
    var best = 0;
    points.forEach(function (q, i) {
      if (Math.hypot(q[0] - x, q[1] - y) < Math.hypot(points[best][0] - x,
        points[best][1] - y)) best = i;
    });
    return best;
  }

  return { picture: picture, plane: plane, boxes: boxes, steps: steps,
    list: list, place: place, many: many, nearest: nearest, BOX: BOX };
})();
