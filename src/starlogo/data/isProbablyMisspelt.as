package starlogo.data
{
    /**
     * Whether a name may be another one, misspelled: at most two letters are inserted, removed, replaced, or exchanged with the next (Damerau, 1964;
     * Levenshtein, 1966), in short names one. Names that differ in numbers alone mean different things. The ES module has its own version.
     *
     * @private
     */
    public function isProbablyMisspelt(name:String, other:String):Boolean
    {
        if (name.length < 4 || name.replace(/\d+/g, "") == other.replace(/\d+/g, ""))
        {
            return false;
        }
        var earlier:Vector.<int> = null;
        var counts:Vector.<int> = new Vector.<int>();
        for (var j:int = 0; j <= other.length; j++)
        {
            counts.push(j);
        }
        for (var i:int = 0; i < name.length; i++)
        {
            var before:Vector.<int> = counts;
            counts = new <int>[i + 1];
            for (j = 0; j < other.length; j++)
            {
                var replaced:int = before[j] + (name.charAt(i) == other.charAt(j) ? 0 : 1);
                var isExchanged:Boolean = i > 0 && j > 0 && name.charAt(i) == other.charAt(j - 1) && name.charAt(i - 1) == other.charAt(j);
                counts.push(Math.min(before[j + 1] + 1, counts[j] + 1, replaced, isExchanged ? earlier[j - 1] + 1 : replaced));
            }
            earlier = before;
        }
        var most:int = Math.max(name.length, other.length) < 6 ? 1 : 2;
        return counts[other.length] <= most || name.toLowerCase() == other.toLowerCase();
    }
}
