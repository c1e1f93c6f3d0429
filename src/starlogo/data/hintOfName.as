package starlogo.data
{
    /**
     * A hint for an error message about a name that is not known: the name that is probably meant, or the names that are. It continues a
     * sentence: it begins with "," or ";". The ES module has its own version.
     *
     * @param name the name that is not known
     * @param names all names that are
     * @param breed the breed of an agent whose shape has the name: if it is among the names, the two are probably exchanged
     * @private
     */
    public function hintOfName(name:String, names:Vector.<String>, breed:String = null):String
    {
        const MOST:int = 10;
        if (names.indexOf(breed) >= 0)
        {
            return "; is new Agent(\"" + breed + "\", \"" + name + "\") meant? The model comes first";
        }
        for each (var known:String in names)
        {
            if (isProbablyMisspelt(name, known))
            {
                return "; is \"" + known + "\" meant?";
            }
        }
        if (names.length == 0)
        {
            return ", which is empty";
        }
        var shown:Vector.<String> = names.concat().sort(Array.CASEINSENSITIVE).slice(0, MOST);
        return "; it has \"" + shown.join("\", \"") + "\"" + (names.length > MOST ? " and " + (names.length - MOST) + " more" : "");
    }
}
