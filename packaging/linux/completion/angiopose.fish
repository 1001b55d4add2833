# fish completion of angiopose
complete -c angiopose -s h -l help -d 'Print the options and exit'
complete -c angiopose -l help-all -d 'Print the options of Qt too and exit'
complete -c angiopose -s v -l version -d 'Print the version and exit'
complete -c angiopose -l renderer -x -a 'auto vtk painter' -d 'Who draws the angiogram'
