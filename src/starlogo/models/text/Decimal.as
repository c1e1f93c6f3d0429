package starlogo.models.text
{
    import starlogo.geometry.roundingOfProduct;

    /**
     * Parses a decimal number to the nearest Number, to the same bits on every machine. A decimal comma is accepted, because some programs write numbers in
     * the system's language. If the decimal is almost halfway between two Numbers
     * (within 1e-12 of their distance), the result is one of these two. The players' own functions differ in the last bits if a number has
     * more than fifteen digits.
     *
     * <p>A decimal with more than fifteen digits is taken as the sum of two Numbers. Products are computed exactly, by the method of T.
     * J. Dekker ("A floating-point technique for extending the available precision", Numerische Mathematik 18, 1971).</p>
     *
     * @private
     */
    public final class Decimal
    {
        // A word of this length has at most fifteen digits, so its digits make a whole Number exactly. If the value is between the limits,
        // the player multiplies or divides the digits once, by a power of ten up to 1e22. Those powers are exact too, so all players round
        // in the same way.
        private static const SHORT:int = 15;
        private static const SMALLEST:Number = 1e-7;
        private static const LARGEST:Number = 1e15;

        // Sign, digits, digits after the point, exponent. Each character fits only one part, so a wrong word is found in linear time.
        private static const PARTS:RegExp = /^([-+]?)(?=[.,]?\d)(\d*)(?:[.,](\d*))?(?:[eE]([-+]?\d+))?$/;

        // players search a pattern in longer words slowly
        private static const LONGEST:int = 10000;
        private static const MAX_DIGITS:int = 30;
        private static const LARGEST_EXPONENT:Number = 99999;
        private static const POWERS:Vector.<Number> = new <Number>[1, 10, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
                1e17, 1e18, 1e19, 1e20, 1e21, 1e22];

        // roundingOfProduct() cannot split larger Numbers
        private static const LARGEST_TO_SPLIT:Number = 1e290;

        /**
         * The number that a word stands for.
         *
         * @param word such as "1", "-.5", "2.50e-3" or "1,5"
         * @return NaN if the word is no number; Infinity if it is too large
         */
        public static function of(word:String):Number
        {
            var length:int = word == null ? 0 : word.length;
            if (length == 0)
            {
                return NaN;
            }
            // Some players read "1e", "0x10", "0b11" or white space before a number. A plain word begins with a digit, a sign or a point, and ends
            // with a digit or a point. After a sign, a point or 0, no letter is in the second or third place.
            const PLUS:int = 0x2B;
            const POINT:int = 0x2E;
            const ZERO:int = 0x30;
            const NINE:int = 0x39;
            var first:int = word.charCodeAt(0);
            var last:int = word.charCodeAt(length - 1);
            var isPlain:Boolean = last >= POINT && last <= NINE && first <= NINE
                && (first > ZERO || first >= PLUS && !(word.charCodeAt(1) > NINE || word.charCodeAt(2) > NINE));
            if (isPlain && length <= SHORT)
            {
                var number:Number = Number(word);
                var size:Number = number < 0 ? -number : number;
                if (size >= SMALLEST && size <= LARGEST || size == 0 && word.search(/[eE]/) < 0)
                {
                    return number;
                }
            }
            return length > LONGEST ? NaN : read(PARTS.exec(word));
        }

        private static function read(parts:Array):Number
        {
            if (parts == null)
            {
                return NaN;
            }
            var fraction:String = parts[3] || "";
            var digits:String = (parts[2] + fraction).replace(/^0+/, "");
            var exponent:Number = parts[4] ? Math.max(-LARGEST_EXPONENT, Math.min(Number(parts[4]), LARGEST_EXPONENT)) : 0;
            exponent += Math.max(0, digits.length - MAX_DIGITS) - fraction.length;
            var behind:String = digits.substring(SHORT, MAX_DIGITS);
            var size:Number = scaled(Number(digits.substr(0, SHORT)), Number(behind), behind.length, exponent);
            return parts[1] == "-" ? -size : size;
        }

        // Returns (first * 10^shift + second) * 10^exponent. first and second are whole and have at most fifteen digits.
        private static function scaled(first:Number, second:Number, shift:int, exponent:Number):Number
        {
            var product:Number = first * POWERS[shift];
            var rest:Number = roundingOfProduct(first, POWERS[shift], product);
            var high:Number = product + second;
            rest += second - (high - product);
            product = high;
            high += rest;
            var low:Number = rest - (high - product);
            while (exponent != 0 && high > 0 && high < Infinity)
            {
                var step:int = Math.min(22, Math.abs(exponent));
                var power:Number = POWERS[step];
                if (exponent > 0)
                {
                    product = high * power;
                    rest = product > LARGEST_TO_SPLIT ? 0 : roundingOfProduct(high, power, product) + low * power;
                    exponent -= step;
                }
                else
                {
                    product = high / power;
                    var back:Number = product * power;
                    rest = (high - back - roundingOfProduct(product, power, back) + low) / power;
                    exponent += step;
                }
                high = product + rest;
                low = rest - (high - product);
            }
            return high;
        }
    }
}
