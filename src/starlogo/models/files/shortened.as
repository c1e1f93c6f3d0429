package starlogo.models.files
{
    /**
     * A text for a message. Of a long one it is the beginning, on one line.
     *
     * @private
     */
    public function shortened(text:String):String
    {
        const LONGEST:int = 60;
        return text == null || text.length <= LONGEST ? text : text.substr(0, LONGEST).replace(/\s+/g, " ") + "...";
    }
}
