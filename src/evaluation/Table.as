package evaluation
{
    /** A text table. The first column is aligned left, the others right. */
    public class Table
    {
        private var _rows:Array = [];

        /** @param head the names of the columns */
        public function Table(...head)
        {
            _rows.push(head);
        }

        /** Adds a row with a cell for each column. */
        public function add(...cells):void
        {
            _rows.push(cells);
        }

        /** The table as text, one line for each row. */
        public function toString():String
        {
            var widths:Array = [];
            for each (var row:Array in _rows)
            {
                for (var column:int = 0; column < row.length; column++)
                {
                    widths[column] = Math.max(int(widths[column]), String(row[column]).length);
                }
            }
            var lines:Array = [];
            for each (row in _rows)
            {
                var cells:Array = [];
                for (column = 0; column < row.length; column++)
                {
                    cells.push(pad(String(row[column]), widths[column], column == 0));
                }
                lines.push(cells.join("  "));
            }
            lines.splice(1, 0, lines[0].replace(/./g, "-"));
            return lines.join("\n");
        }

        private static function pad(text:String, width:int, left:Boolean):String
        {
            while (text.length < width)
            {
                text = left ? text + " " : " " + text;
            }
            return text;
        }
    }
}
