// The slider above a picture covers the plate with the pinhole's view, from the right. The frame has
// the shape of what is shown, and between the two a shape in between.
for (const compare of document.querySelectorAll(".compare")) {
    const slider = compare.closest("section").querySelector("input");
    const [plate, pinhole] = compare.querySelectorAll("img");
    const show = () => {
        if (!plate.naturalWidth || !pinhole.naturalWidth) {
            return;
        }
        const share = slider.value / 100;
        const height = (image) => image.naturalHeight / image.naturalWidth;
        compare.classList.add("sized");
        compare.style.setProperty("--share", slider.value + "%");
        compare.style.aspectRatio = 1 / (share * height(plate) + (1 - share) * height(pinhole));
    };
    slider.addEventListener("input", show);
    for (const image of [plate, pinhole]) {
        image.addEventListener("load", show);
    }
    show();
}
