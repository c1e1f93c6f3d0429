package starlogo.data
{
    /**
     * Whether a name may be another one, misspelled: at most two letters are inserted, removed or replaced (Levenshtein, 1966), in short names one.
     * Names that differ in numbers alone mean different things. The ES module has its own version, for which two letters that are exchanged
     * count as one.
     *
     * @private
     */
    public function isProbablyMisspelt(name:String, other:String):Boolean
    {
        if (name.length < 4 || name.replace(/\d+/g, "") == other.replace(/\d+/g, ""))
        {
            return false;
        }
        var counts:Vector.<int> = new Vector.<int>();
        for (var j:int = 0; j <= other.length; j++)
        {
            counts.push(j);
        }
        for (var i:int = 0; i < name.length; i++)
        {
            var before:int = counts[0];
            counts[0] = i + 1;
            for (j = 0; j < other.length; j++)
            {
                var replaced:int = before + (name.charAt(i) == other.charAt(j) ? 0 : 1);
                before = counts[j + 1];
                counts[j + 1] = Math.min(before + 1, counts[j] + 1, replaced);
            }
        }
        var most:int = Math.max(name.length, other.length) < 6 ? 1 : 2;
        return counts[other.length] <= most || name.toLowerCase() == other.toLowerCase();
    }
}
