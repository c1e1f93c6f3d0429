package starlogo.models
{
    /**
     * What a player's error says, without its number and what goes before the address: "Error #2032: Stream Error. URL: bear.obj" is "bear.obj",
     * and without an address nothing.
     *
     * @private
     */
    public function plainMessage(message:String):String
    {
        return message.replace(/^Error #\d+: (Stream Error(\. |$))?(URL: )?/, "");
    }
}
