// The slider below a picture covers the plate with the pinhole's view, from the right.
for (const slider of document.querySelectorAll(".slider input")) {
    const compare = slider.closest("section").querySelector(".compare");
    const show = () => compare.style.setProperty("--share", slider.value + "%");
    slider.addEventListener("input", show);
    show();
}
