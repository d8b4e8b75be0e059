// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

/** Follows a pointer that is pressed on the element that listens, wherever it goes, until it is let go. */
export function followPointer(
    begin: PointerEvent,
    move: (event: PointerEvent) => void,
    end: (event: Event) => void = () => {},
): void {
    const target = begin.currentTarget as Element;
    target.setPointerCapture(begin.pointerId);
    target.addEventListener("pointermove", move as EventListener);
    const stop = (event: Event): void => {
        target.removeEventListener("pointermove", move as EventListener);
        end(event);
    };
    target.addEventListener("lostpointercapture", stop, { once: true });
}
