// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Paragraphs of exactly two pictures get a slider; a choice on the page shows all of them side by
// side or one over the other. Without scripts they are two pictures.
document.addEventListener("DOMContentLoaded", () => {
    const article = document.querySelector("article");
    const pairs = [...article.querySelectorAll("p")].filter(
        (p) => p.children.length === 2 && p.querySelectorAll("img").length === 2 && !p.innerText.trim());
    for (const pair of pairs) {
        const slider = document.createElement("input");
        slider.type = "range";
        slider.value = 50;
        slider.setAttribute("aria-label", [...pair.querySelectorAll("img")].map((i) => i.alt).join(" | "));
        slider.addEventListener("input", () => pair.style.setProperty("--border", `${slider.value}%`));
        pair.classList.add("pair");
        pair.append(slider);
    }
    if (pairs.length < 2) {
        return;
    }
    const choice = document.createElement("label");
    const box = document.createElement("input");
    box.type = "checkbox";
    box.addEventListener("change", () => article.classList.toggle("over", box.checked));
    choice.className = "pair-choice";
    choice.append(box, " one over the other, with a slider");
    article.querySelector("h1").after(choice);
});
