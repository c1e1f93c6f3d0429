package support
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;

    use namespace engine;

    /** Everything that a GreatLand holds of a model as text, to the last digit: two of them can be compared. */
    public final class LibraryContents
    {
        /** The model's structures and all nodes of its hierarchy. */
        public static function of(greatLand:GreatLand, name:String):String
        {
            var lines:Array = [greatLand.hasModel(name)];
            if (greatLand.boundingStructures.has(name))
            {
                lines.push("tightest " + textOf(greatLand.boundingStructures.tightestFit(name)));
            }
            if (greatLand.boundingStructures.hasAll(name))
            {
                lines.push(textOf(greatLand.boundingStructures.sphere(name)), textOf(greatLand.boundingStructures.box(name)),
                        textOf(greatLand.boundingStructures.capsule(name)));
            }
            if (greatLand.loadHulls)
            {
                lines.push("hull " + textOf(greatLand.boundingStructures.hull(name)));
            }
            if (greatLand.hierarchies.has(name))
            {
                addNodes(greatLand.hierarchies.root(name), lines);
            }
            return lines.join("\n");
        }

        private static function addNodes(node:HierarchyNode, lines:Array):void
        {
            lines.push(textOf(node.bounds) + " " + node.vertexCount + ": " + (node.isLeaf ? node.triangleIndices().join() + "/" + node.vertexIndices().join() : ""));
            if (!node.isLeaf)
            {
                addNodes(node.left, lines);
                addNodes(node.right, lines);
            }
        }

        private static function textOf(structure:BoundingStructure):String
        {
            switch (structure.kind)
            {
                case BoundingStructure.SPHERE:
                    return "sphere " + [vector(Sphere(structure).center), Sphere(structure).radius];
                case BoundingStructure.CAPSULE:
                    var capsule:Capsule = Capsule(structure);
                    return "capsule " + [vector(capsule.start), vector(capsule.end), capsule.radius];
                case BoundingStructure.HULL:
                    return "hull " + [Hull(structure).toNumbers(), Hull(structure).faces];
                default:
                    var box:Box = Box(structure);
                    return "box " + [vector(box.center), vector(box.axisX), vector(box.axisY), vector(box.axisZ), box.halfX,
                            box.halfY, box.halfZ];
            }
        }

        private static function vector(point:Vector3D):Array
        {
            return [point.x, point.y, point.z];
        }
    }
}
