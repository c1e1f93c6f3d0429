package support
{
    import starlogo.GreatLand;
    import starlogo.models.Model;

    /** A GreatLand with models. Each argument is a Model or an Array of them. */
    public function landOf(...models):GreatLand
    {
        var land:GreatLand = new GreatLand();
        for each (var each:* in models)
        {
            for each (var model:Model in each is Model ? [each] : each)
            {
                land.addModel(model);
            }
        }
        return land;
    }
}
