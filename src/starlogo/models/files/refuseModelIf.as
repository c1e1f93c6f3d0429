package starlogo.models.files
{
    import starlogo.models.ModelError;

    /**
     * Throws a ModelError if something is wrong with a model, its file or the arguments for it. The message is built in any case, so long loops
     * throw their errors themselves.
     *
     * @param isWrong whether it is wrong
     * @param name the model's name
     * @param problem what is wrong
     * @param place where in the file: a text, or an object with a toString()
     * @throws ModelError if it is wrong
     *
     * @private
     */
    public function refuseModelIf(isWrong:Boolean, name:String, problem:String, place:Object = ""):void
    {
        if (isWrong)
        {
            throw new ModelError(name, String(place), problem);
        }
    }
}
