package starlogo.models.building
{
    /**
     * Makes points without a surface the vertices of a model, if it has no others.
     *
     * @param data what is read of the model
     * @param points x, y, z of each; kept
     * @param expected for the error: what the file must have
     * @throws ModelError if there are no such points either
     *
     * @private
     */
    public function takeLoosePoints(data:ModelData, points:Vector.<Number>, expected:String):void
    {
        data.vertices = data.vertices.length == 0 ? points : data.vertices;
        refuseIf(data.vertices.length == 0, data.name, "no vertices: expected " + expected);
    }
}
