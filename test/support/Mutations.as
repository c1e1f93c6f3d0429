package support
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;

    /** Damages files the way disks, networks and hands do. */
    public final class Mutations
    {
        private static const NUMBERS:Array = ["nan", "NaN", "inf", "-inf", "1e308", "-1e308", "1e999", "5e-324",
                "-1", "0", "1", "-0", "1e9",
                "999999999", "2147483647", "2147483648", "4294967295", "4294967296", "1e20", "0.5", "1,5", "0x10",
                "", "1e", "x", "#", "#a"];
        private static const PIECES:Array = ["<", ">", "/>", "</", "&", "\"", "'", "\\", "\\\n", "\n", "\r", " ",
                "#", "/", "//", "-", "<!--", "]]>",
                "<node>", "</node>", "<p>", "f 1 1 1\n", "v 1 1 1\n", "\u0000", "\uFFFF", "\uE000", "\uFEFF"];

        /** The text with one to three damages. */
        public static function ofText(text:String, random:SeededRandom):String
        {
            for (var i:int = random.integer(1, 3); i > 0; i--)
            {
                text = damaged(text, random);
            }
            return text;
        }

        /** A copy of bytes with one to three damages. */
        public static function ofBytes(bytes:ByteArray, random:SeededRandom):ByteArray
        {
            var copy:ByteArray = new ByteArray();
            copy.writeBytes(bytes);
            for (var i:int = random.integer(1, 3); i > 0 && copy.length > 0; i--)
            {
                if (random.chance(0.1))
                {
                    copy.length = random.integer(0, copy.length);
                }
                else
                {
                    copy[random.integer(0, copy.length - 1)] = random.integer(0, 255);
                }
            }
            return copy;
        }

        private static function damaged(text:String, random:SeededRandom):String
        {
            var start:int = random.integer(0, text.length);
            var end:int = Math.min(text.length, start + int(random.logBetween(1, 200)));
            var span:String = text.substring(start, end);
            switch (random.integer(0, 8))
            {
                case 0:
                    return text.substr(0, start);
                case 1:
                    return text.substr(0, start) + text.substr(end);
                case 2:
                    return text.substr(0, end) + repeated(span, random.integer(1, 20)) + text.substr(end);
                case 3:
                    return swapped(text, start, end, random);
                case 4:
                    return text.substr(0, start) + String.fromCharCode(random.integer(1, 255)) + text.substr(start + 1);
                case 5:
                    return text.substr(0, start) + random.pick(PIECES) + text.substr(start);
                default:
                    return withNumberReplaced(text, start, random.pick(NUMBERS));
            }
        }

        private static function repeated(span:String, times:int):String
        {
            var all:String = "";
            for (var i:int = 0; i < times; i++)
            {
                all += span;
            }
            return all;
        }

        private static function swapped(text:String, start:int, end:int, random:SeededRandom):String
        {
            var target:int = random.integer(0, text.length);
            var without:String = text.substr(0, start) + text.substr(end);
            return without.substr(0, target) + text.substring(start, end) + without.substr(target);
        }

        private static function withNumberReplaced(text:String, start:int, replacement:String):String
        {
            var rest:String = text.substr(start);
            var number:Array = rest.match(/[-+.\d][-+.\deE]*/);
            return number == null ? text : text.substr(0, start) + rest.replace(number[0], replacement);
        }
    }
}
