package starlogo.data
{
    /**
     * Says that something is probably a mistake, once. Nothing is refused. In ActionScript it is traced. The ES module has its own version,
     * which writes to the console, and only while a game is developed.
     *
     * @param message says what is meant, and what to do
     * @return whether it is said: false if it was said before
     * @private
     */
    public function warn(message:String):Boolean
    {
        var isNew:Boolean = !(message in SAID);
        if (isNew)
        {
            SAID[message] = true;
            trace("starlogo: " + message);
        }
        return isNew;
    }
}

/** The messages that were said, as keys. */
const SAID:Object = {};
