// Pictures on a canvas: one of them, or two with a line between them, at any zoom, with frames about differing pixels.

const marks = {
  face: 'square',
  order: 'diamond',
  start: 'disc',
  unexamined: 'cross'
};

/** Draws `images`, by name, once they are there; `mode` names one, or is `slider` for `method` beside `against`. */
export class Viewer {
  constructor(canvas, {width, height}, pixels) {
    Object.assign(this, {
      canvas,
      width,
      height,
      pixels,
      split: 0.5,
      mode: 'slider',
      zoom: 1,
      centre: [width / 2, height / 2],
      chosen: null,
      images: {},
      marked: true
    });
  }

  get scale() {
    return (this.canvas.clientWidth / this.width) * this.zoom;
  }

  /** Corner of the picture on the canvas, in CSS pixels. */
  origin() {
    const {clientWidth, clientHeight} = this.canvas;
    const clamp = (c, size, seen) => Math.max(seen / 2, Math.min(size - seen / 2, c));
    this.centre = [
      clamp(this.centre[0], this.width, clientWidth / this.scale),
      clamp(this.centre[1], this.height, clientHeight / this.scale)
    ];
    return [clientWidth / 2 - this.centre[0] * this.scale, clientHeight / 2 - this.centre[1] * this.scale];
  }

  draw() {
    const {canvas, scale} = this;
    const ratio = window.devicePixelRatio;
    const [w, hgt] = [canvas.clientWidth, canvas.clientHeight];
    if (w === 0) return;
    canvas.width = Math.round(w * ratio);
    canvas.height = Math.round(hgt * ratio);
    const g = canvas.getContext('2d');
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.imageSmoothingEnabled = false;
    const [x, y] = this.origin();
    const put = (image) => image && g.drawImage(image, x, y, this.width * scale, this.height * scale);
    if (this.mode === 'slider') {
      put(this.images.against);
      g.save();
      g.beginPath();
      g.rect(0, 0, w * this.split, hgt);
      g.clip();
      put(this.images.method);
      g.restore();
      g.fillStyle = '#000';
      g.fillRect(w * this.split - 1.5, 0, 3, hgt);
      g.fillStyle = '#fff';
      g.fillRect(w * this.split - 0.5, 0, 1, hgt);
    } else
      put(this.images[this.mode]);
    this.drawMarks(g, x, y);
  }

  /**
   * A frame about each differing pixel, or only about the chosen one, in a shape for its reason once there is room.
   */
  drawMarks(g, x, y) {
    const {scale} = this;
    const size = Math.max(scale, 5);
    for (const pixel of this.marked ? this.pixels : this.pixels.filter((one) => one === this.chosen)) {
      const [cx, cy] = [x + (pixel.x + 0.5) * scale, y + (pixel.y + 0.5) * scale];
      const chosen = pixel === this.chosen;
      for (const [colour, width] of [
               ['#000', chosen ? 5 : 3], [pixel.why === 'start' ? '#7cc7ff' : '#ffd400', chosen ? 2.5 : 1.2]]) {
        g.strokeStyle = colour;
        g.lineWidth = width;
        g.beginPath();
        if (marks[pixel.why] === 'disc')
          g.arc(cx, cy, size / 2, 0, 2 * Math.PI);
        else
          g.rect(cx - size / 2, cy - size / 2, size, size);
        g.stroke();
      }
    }
  }

  /** The pixel of the picture at a place on the canvas. */
  pixelAt(left, top) {
    const [x, y] = this.origin();
    return [Math.floor((left - x) / this.scale), Math.floor((top - y) / this.scale)];
  }

  /** The nearest differing pixel within some screen pixels. */
  nearest(left, top) {
    const [x, y] = this.origin();
    const gap = (p) => Math.hypot(x + (p.x + 0.5) * this.scale - left, y + (p.y + 0.5) * this.scale - top);
    const best = this.pixels.reduce((a, p) => (a === null || gap(p) < gap(a) ? p : a), null);
    return best && gap(best) <= Math.max(10, this.scale) ? best : null;
  }
}
