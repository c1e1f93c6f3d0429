package starlogo.models.text
{
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Splits text into words, and trims and replaces. It uses the player's native functions, because a loop over characters is slow.
     *
     * @private
     */
    public final class TextWords
    {
        private static const CHARACTERS_PER_STEP:int = 200000;
        private static const SPACE:int = 0x20;

        /** The words of a text, separated by spaces, tabs and ends of lines. Empty for a text without words. */
        public static function of(text:String):Array
        {
            text = replaceAll(text, "\n", " ");
            text = replaceAll(text, "\r", " ");
            text = trimmed(singleSpaced(replaceAll(text, "\t", " ")));
            return text == "" ? [] : text.split(" ");
        }

        /**
         * The steps that split a long text into words.
         *
         * @param out takes the words
         */
        public static function splitting(text:String, out:Array):Steps
        {
            var start:int = 0;
            return new StepSequence().repeat(function():Boolean
                {
                    var end:int = Math.min(start + CHARACTERS_PER_STEP, text.length);
                    while (end < text.length && text.charCodeAt(end) > SPACE)
                    {
                        end++;
                    }
                    for each (var word:String in of(text.substring(start, end)))
                    {
                        out.push(word);
                    }
                    start = end;
                    return start < text.length;
                });
        }

        /** The text without the spaces, tabs and ends of lines around it. */
        public static function trimmed(text:String):String
        {
            var start:int = 0;
            var end:int = text.length;
            while (text.charCodeAt(start) <= SPACE)
            {
                start++;
            }
            while (end > start && text.charCodeAt(end - 1) <= SPACE)
            {
                end--;
            }
            return text.substring(start, end);
        }

        /** The text with one space wherever there are more in a row. */
        public static function singleSpaced(text:String):String
        {
            while (text.indexOf("  ") >= 0)
            {
                text = replaceAll(text, "  ", " ");
            }
            return text;
        }

        /** The text with every occurrence of a piece replaced. */
        public static function replaceAll(text:String, piece:String, replacement:String):String
        {
            return text.indexOf(piece) < 0 ? text : text.split(piece).join(replacement);
        }

        /** The index of the first of two characters from an index on; the end if there is none before it. */
        public static function indexOfEither(text:String, first:int, second:int, from:int, end:int):int
        {
            var at:int = from;
            var code:int = text.charCodeAt(at);
            while (at < end && code != first && code != second)
            {
                code = text.charCodeAt(++at);
            }
            return at;
        }
    }
}
