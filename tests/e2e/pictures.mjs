// Pictures made by code, as PNG files, and what is seen on a screenshot.

import { deflateSync } from 'node:zlib';

/** CRC-32, as PNG wants it; Node 18 has none of its own. */
function checksum(bytes) {
  let crc = ~0;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}

function chunk(type, data) {
  const out = Buffer.alloc(12 + data.length);
  out.writeUInt32BE(data.length, 0);
  out.write(type, 4, 'latin1');
  data.copy(out, 8);
  out.writeUInt32BE(checksum(out.subarray(4, 8 + data.length)), 8 + data.length);
  return out;
}

/** `colour` gives red, green and blue of a pixel. */
export function png(width, height, colour) {
  const rows = Buffer.alloc(height * (1 + 3 * width));
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) rows.set(colour(x, y), y * (1 + 3 * width) + 1 + 3 * x);
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 2, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(rows)),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

/** Two by two squares, blue at the upper left and the lower right. */
export const checks = png(64, 64, (x, y) => (x < 32 === y < 32 ? [20, 60, 190] : [245, 242, 235]));

/** The share of pixels of a part of the page that are clearly blue. */
export async function shareOfBlue(page, locator) {
  const picture = (await locator.screenshot()).toString('base64');
  return page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width, image.height];
    const pen = canvas.getContext('2d');
    pen.drawImage(image, 0, 0);
    const { data } = pen.getImageData(0, 0, canvas.width, canvas.height);
    let blue = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i + 2] > data[i] + 50) ++blue;
    return blue / (data.length / 4);
  }, picture);
}

/** The mean red, green and blue of a few pixels in the middle of a part of the page. */
export async function colourAtMiddle(page, locator) {
  const picture = (await locator.screenshot()).toString('base64');
  return page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const side = 16;
    const canvas = new OffscreenCanvas(side, side);
    const pen = canvas.getContext('2d');
    pen.drawImage(image, (side - image.width) / 2, (side - image.height) / 2);
    const { data } = pen.getImageData(0, 0, side, side);
    return [0, 1, 2].map((k) => data.filter((_, i) => i % 4 === k).reduce((sum, value) => sum + value, 0) / (side * side));
  }, picture);
}
