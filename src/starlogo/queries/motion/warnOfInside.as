package starlogo.queries.motion
{
    import starlogo.convex.ContactPoint;

    /**
     * Warns of a motion that begins so deep inside of a tree that the tree does not stop it: in a closed room, for example, which is solid. Warns too if
     * all of the body begins inside of another structure, with room to spare: inside of the structure around a level, for example. Such motions may come
     * in every frame. So in ActionScript this does nothing. The ES module has its own version, which warns once.
     *
     * @param body the body where its motion begins
     * @param row the row that it overlaps
     * @param contact the contact of the two
     * @private
     */
    public function warnOfInside(body:MovingBody, row:int, contact:ContactPoint):void
    {
    }
}
