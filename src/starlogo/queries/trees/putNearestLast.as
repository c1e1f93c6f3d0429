package starlogo.queries.trees
{
    import starlogo.data.SortableIntList;

    /**
     * Puts the nearest of some nodes at the top of a stack.
     *
     * @param stack nodes, with their distances as keys
     * @param first the index of the first of these nodes. They are at the top of the stack
     * @private
     */
    public function putNearestLast(stack:SortableIntList, first:int):void
    {
        var last:int = stack.count - 1;
        var nearest:int = last;
        for (var i:int = first; i < last; i++)
        {
            if (stack.keys[i] < stack.keys[nearest])
            {
                nearest = i;
            }
        }
        if (nearest == last)
        {
            return;
        }
        var node:int = stack.values[nearest];
        var distance:Number = stack.keys[nearest];
        stack.values[nearest] = stack.values[last];
        stack.keys[nearest] = stack.keys[last];
        stack.values[last] = node;
        stack.keys[last] = distance;
    }
}
