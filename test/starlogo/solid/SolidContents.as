package starlogo.solid
{
    import starlogo.GreatLand;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.solid.interior.Interior;
    import starlogo.solid.interior.SurfaceTopology;

    use namespace engine;

    /** Everything that exact colliders need of a model as text, to the last digit. */
    public final class SolidContents
    {
        /** The solid of a model, which is prepared if it was not. */
        public static function of(greatLand:GreatLand, name:String):String
        {
            var hierarchy:ModelTree = greatLand.hierarchies.treeOf(name);
            if (!hierarchy.hasTriangles)
            {
                return "none";
            }
            var interior:Interior = hierarchy.preparedInterior();
            var surface:SurfaceTopology = interior.surface;
            return [interior.hasClosedShell, surface.orientedShells, surface.shellStates, surface.widestSeam, interior.welded, surface.componentTriangles, interior.tree.cornerOffsets,
                    interior.tree.vertices, axesOf(hierarchy.boxTree)].join("\n");
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
