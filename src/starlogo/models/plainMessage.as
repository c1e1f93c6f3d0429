package starlogo.models
{
    /**
     * A player's error message without its number and without the words before the address. "Error #2032: Stream Error. URL: bear.obj"
     * becomes "bear.obj"; without an address the result is empty.
     *
     * @private
     */
    public function plainMessage(message:String):String
    {
        return message.replace(/^Error #\d+: (Stream Error(\. |$))?(URL: )?/, "");
    }
}
