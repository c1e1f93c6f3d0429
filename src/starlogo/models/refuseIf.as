package starlogo.models
{
    /**
     * Refuses a model's file if something is wrong with it. The message is made in any case: long loops throw their errors themselves.
     *
     * @param isWrong whether it is
     * @param name the model's name
     * @param problem what is wrong
     * @param place where, as ModelError has it, or what is there
     * @throws ModelError if it is wrong
     *
     * @private
     */
    public function refuseIf(isWrong:Boolean, name:String, problem:String, place:Object = ""):void
    {
        if (isWrong)
        {
            throw new ModelError(name, String(place), problem);
        }
    }
}
