package starlogo.solid
{
    import starlogo.GreatLand;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;

    use namespace engine;

    /** Everything that exact colliders need of a model as text, to the last digit. */
    public final class SolidContents
    {
        /** The solid of a model, which is prepared if it was not. */
        public static function of(greatLand:GreatLand, name:String):String
        {
            var hierarchy:ModelTree = greatLand.hierarchies.hierarchy(name);
            if (!hierarchy.hasTriangles)
            {
                return "none";
            }
            var solid:Interior = hierarchy.prepareInterior();
            return [solid.isClosed, solid.surface.signedShells, solid.surface.shellStates, solid.surface.widestSeam, solid.places, solid.placesAt, solid.leastPartExtent, solid.partPoints, solid.mesh.corners,
                    solid.mesh.prepareExtents(), solid.mesh.preparePlanes(), axesOf(hierarchy.tree)].join("\n");
        }

        private static function axesOf(tree:BoxTree):String
        {
            var axes:Array = [];
            for (var node:int = 0; node < tree.left.length; node++)
            {
                axes.push(tree.left[node] == 0 ? "." : tree.axisOf(node));
            }
            return axes.join("");
        }
    }
}
