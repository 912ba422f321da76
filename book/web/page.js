// What a page can do where there are scripts, and does without where
// there are none: light or dark by hand, answers printed with their
// questions, and "/" for the search.
"use strict";

(function () {
  var root = document.documentElement;

  // ---- light and dark ----------------------------------------------------
  var themes = ["", "light", "dark"];
  var names = ["as the system", "light", "dark"];

  function remembered() {
    try { return localStorage.getItem("theme") || ""; } catch (e) { return ""; }
  }

  function remember(theme) {
    try { localStorage.setItem("theme", theme); } catch (e) { /* none here */ }
  }

  var button = document.createElement("button");
  function show(theme) {
    if (theme) root.dataset.theme = theme; else delete root.dataset.theme;
    button.textContent = "Light: " + names[themes.indexOf(theme)];
  }

  button.type = "button";
  button.className = "theme";
  button.addEventListener("click", function () {
    var next = themes[(themes.indexOf(remembered()) + 1) % themes.length];
    remember(next);
    show(next);
  });
  show(remembered());
  document.querySelector("header nav").append(button);

  // ---- on paper ------------------------------------------------------------
  addEventListener("beforeprint", function () {
    document.querySelectorAll("main details:not([open])").forEach(
      function (d) { d.open = true; d.dataset.closed = ""; });
  });
  addEventListener("afterprint", function () {
    document.querySelectorAll("details[data-closed]").forEach(
      function (d) { d.open = false; delete d.dataset.closed; });
  });

  // ---- a place that is folded away -------------------------------------------
  function unfold() {
    var id = decodeURIComponent(location.hash.slice(1));
    var target = id && document.getElementById(id);
    var folded = target && target.closest("details:not([open])");
    if (folded) { folded.open = true; target.scrollIntoView(); }
  }
  addEventListener("hashchange", unfold);
  unfold();

  addEventListener("keydown", function (event) {
    if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey ||
        /^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName)) return;
    event.preventDefault();
    location.href = document.querySelector('header a[href$="search.html"]').href;
  });
})();
