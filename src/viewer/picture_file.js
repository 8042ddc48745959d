// The scene as a PNG file, with its name and what is shown below it, on the background of the page.

export function save_picture(canvas, { name, caption, paper, ink, muted }) {
  const made = document.createElement('canvas');
  const scale = canvas.width / Math.max(1, canvas.clientWidth);
  const bar = Math.round(46 * scale);
  Object.assign(made, { width: canvas.width, height: canvas.height + bar });
  const context = made.getContext('2d');
  context.fillStyle = paper;
  context.fillRect(0, 0, made.width, made.height);
  context.drawImage(canvas, 0, 0);
  context.textBaseline = 'middle';
  context.fillStyle = ink;
  context.font = `600 ${Math.round(15 * scale)}px Georgia, serif`;
  context.fillText(name, 16 * scale, canvas.height + bar * 0.3, made.width - 32 * scale);
  context.fillStyle = muted;
  context.font = `${Math.round(12 * scale)}px system-ui, sans-serif`;
  context.fillText(caption, 16 * scale, canvas.height + bar * 0.72, made.width - 32 * scale);
  return new Promise((done) =>
    made.toBlob((blob) => {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(blob);
      link.download = `${name.replace(/[^\w.-]+/g, '_') || 'flow_complex'}.png`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
      done({ bytes: blob.size, file: link.download });
    }, 'image/png'),
  );
}
