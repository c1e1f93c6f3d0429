package docs
{
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;

    /** For docs/poses.md: the vertices of a model that a game moves. */
    public class PosesPage extends Page
    {
        public static const FIXTURES:Array = [];

        protected var vertices:Vector.<Number> = BuiltInModel.cube().vertices.slice();
        protected var triangles:Vector.<uint> = BuiltInModel.cube().triangles;

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            var model:Model = shown.walking;
            for (var i:int = 0; i < vertices.length; i++)
            {
                assertTrue(Math.abs(model.vertices[i] - vertices[i]) < 1e-12);
            }
        }
    }
}
