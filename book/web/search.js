// Looks for words in every section of the book. index.js has them all,
// as [address, page, title, words]; nothing is asked of a server.
"use strict";

(function () {
  var MOST = 60;   // results
  var AROUND = 90; // characters of the text before a word and after it

  function words(query) {
    return query.toLowerCase().split(/\s+/).filter(Boolean);
  }

  // A section counts if it has all the words: more, if its title does,
  // and less, if it is a file.
  function score(entry, wanted) {
    var title = (entry[1] + " " + entry[2]).toLowerCase();
    var text = entry[3].toLowerCase(), sum = 0;
    for (var i = 0; i < wanted.length; i++) {
      var times = text.split(wanted[i]).length - 1;
      var titled = title.indexOf(wanted[i]) >= 0;
      if (!times && !titled) return 0;
      sum += Math.min(times, 10) + (titled ? 20 : 0);
    }
    return entry[0].indexOf("/") > 0 ? sum / 4 : sum;
  }

  // The text around the first of the words, with all of them marked.
  function excerpt(text, wanted) {
    var p = document.createElement("p"), low = text.toLowerCase(), first = -1;
    wanted.forEach(function (w) {
      var at = low.indexOf(w);
      if (at >= 0 && (first < 0 || at < first)) first = at;
    });
    var from = Math.max(0, first - AROUND);
    var part = text.slice(from, Math.max(0, first) + AROUND * 2);
    if (from > 0) p.append("… ");
    var at = 0, lower = part.toLowerCase();
    while (at < part.length) {
      var next = part.length, length = 0;
      wanted.forEach(function (w) {
        var i = lower.indexOf(w, at);
        if (i >= 0 && i < next) { next = i; length = w.length; }
      });
      p.append(part.slice(at, next));
      if (length) {
        var mark = document.createElement("mark");
        mark.textContent = part.slice(next, next + length);
        p.append(mark);
      }
      at = next + Math.max(length, 1);
    }
    p.append(" …");
    return p;
  }

  function item(entry, wanted) {
    var li = document.createElement("li"), a = document.createElement("a");
    a.href = entry[0];
    a.textContent = entry[2] ? entry[2] + " (" + entry[1] + ")" : entry[1];
    li.append(a, excerpt(entry[3], wanted));
    return li;
  }

  function search(query) {
    var wanted = words(query), list = document.getElementById("results");
    var said = document.getElementById("found");
    list.replaceChildren();
    if (!wanted.length) {
      said.textContent = "Sections that have all the words are found.";
      return;
    }
    var found = NEAR_AND_FAR.map(function (entry) {
      return [score(entry, wanted), entry];
    }).filter(function (pair) { return pair[0] > 0; });
    found.sort(function (a, b) { return b[0] - a[0]; });
    said.textContent = found.length === 1 ? "One section has it."
      : found.length + " sections have it" + (found.length > MOST
        ? "; here are the first " + MOST + "." : ".");
    found.slice(0, MOST).forEach(function (pair) {
      list.append(item(pair[1], wanted));
    });
  }

  var input = document.getElementById("words");
  var asked = new URLSearchParams(location.search).get("q");
  if (asked) input.value = asked;
  search(input.value);
  input.addEventListener("input", function () { search(input.value); });
  input.form.addEventListener("submit", function (event) {
    event.preventDefault();
    search(input.value);
  });
})();
