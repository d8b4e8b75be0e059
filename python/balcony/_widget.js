// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A picture with a slider for each parameter of its camera, by the protocol of anywidget
// (https://anywidget.dev): the model has `sliders`, `values`, `picture`, `message` and
// `done`, the number of times that values were answered.

function sliderRow(slider, change) {
    const row = document.createElement("label");
    row.style.display = "flex";
    row.style.gap = "0.5em";
    const name = document.createElement("span");
    name.style.width = "8em";
    name.textContent = slider.name;
    const input = document.createElement("input");
    Object.assign(input, {type: "range", min: slider.least, max: slider.most, step: "any", value: slider.value});
    input.style.flex = "1";
    const shown = document.createElement("span");
    shown.style.width = "6em";
    const show = () => { shown.textContent = Number(input.value).toPrecision(4) + slider.unit; };
    show();
    input.addEventListener("input", () => {
        show();
        change(slider.name, Number(input.value));
    });
    row.append(name, input, shown);
    return row;
}

function render({model, el}) {
    const picture = document.createElement("img");
    picture.style.maxWidth = "100%";
    const message = document.createElement("div");
    message.setAttribute("role", "status");
    // The newest values wait while others are answered.
    let waiting = null;
    let isBusy = false;
    const send = (values) => {
        isBusy = true;
        waiting = null;
        model.set("values", values);
        model.save_changes();
    };
    const rows = model.get("sliders").map((slider) => sliderRow(slider, (name, value) => {
        const values = {...(waiting ?? model.get("values")), [name]: value};
        if (isBusy) {
            waiting = values;
        } else {
            send(values);
        }
    }));
    const answered = () => {
        isBusy = false;
        if (waiting) {
            send(waiting);
        }
    };
    let url = "";
    const showPicture = () => {
        const before = url;
        url = URL.createObjectURL(new Blob([model.get("picture")], {type: "image/png"}));
        picture.src = url;
        if (before) {
            URL.revokeObjectURL(before);
        }
    };
    const showMessage = () => {
        message.textContent = model.get("message");
    };
    showPicture();
    showMessage();
    model.on("change:picture", showPicture);
    model.on("change:message", showMessage);
    model.on("change:done", answered);
    el.append(picture, message, ...rows);
    return () => {
        model.off("change:picture", showPicture);
        model.off("change:message", showMessage);
        model.off("change:done", answered);
        URL.revokeObjectURL(url);
    };
}

export default {render};
