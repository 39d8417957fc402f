// Numbers as people read them.

const SUPERSCRIPT = '⁰¹²³⁴⁵⁶⁷⁸⁹';
const superscript = (n) => (n < 0 ? '⁻' : '') + String(Math.abs(n)).split('').map((c) => SUPERSCRIPT[+c]).join('');

/** Some three digits: 0.0123, 1 234, 1.23·10⁻⁵. */
export function shortNumber(x, digits = 3) {
  if (x === null || x === undefined || Number.isNaN(x)) return '–';
  if (!Number.isFinite(x)) return x > 0 ? '∞' : '−∞';
  if (x === 0) return '0';
  const power = Math.floor(Math.log10(Math.abs(x)));
  if (power < -4 || power >= 7) {
    const [m, e] = x.toExponential(digits - 1).split('e');
    const mantissa = m.includes('.') ? m.replace(/0+$/, '').replace(/\.$/, '') : m;
    return (mantissa === '1' ? '' : minus(mantissa) + '·') + '10' + superscript(+e);
  }
  const text = power >= digits ? String(Math.round(x)) : String(+x.toPrecision(digits));
  return minus(power >= 4 ? grouped(text) : text);
}

/** All of a double. */
export function fullNumber(x) {
  return minus(String(x));
}

export function grouped(n) {
  return String(n).replace(/\B(?=(\d{3})+(?!\d))/g, '\u202f');
}

function minus(text) {
  return text.replace('-', '−');
}

/** The size of a unit in the last place of x. */
export function ulpOf(x) {
  x = Math.abs(x);
  if (!(x > 0) || !Number.isFinite(x)) return 0;
  const power = Math.max(-1022, Math.floor(Math.log2(x)));
  const unit = 2 ** (power - 52);
  return x >= 2 ** (power + 1) ? 2 * unit : unit;
}
